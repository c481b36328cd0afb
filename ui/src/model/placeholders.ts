/**
 * Blocks that this editor does not know, or knows in another form, travel through Blockly as grey placeholders: what they
 * hold is kept as it came and written back unchanged.
 */
import { type Catalog, type PackArg, type PackBlock, cutText, endsStack } from '../blocks/pack';
import { linkIn, linkOut } from './chains';
import type { BlockState, ConnectionState, WorkspaceState } from './program';

export const placeholder = 'mirada_unknown';

type Role = 'top' | 'statement' | 'value';
type InputKind = 'value' | 'statement';

/** All of a placeholder's block but what Blockly itself carries: id, place, inputs and next. */
export interface Kept {
  type: string;
  role: Role;
  keys: string[];
  state: Record<string, unknown>;
  inputs: { name: string; kind: InputKind }[];
}

const carried = new Set(['id', 'x', 'y', 'inputs', 'next']);
const valueShapes = new Set(['reporter', 'boolean']);
const shadows: Record<string, string> = { math_number: 'NUM', math_angle: 'NUM', text: 'TEXT' };
const own = new Set([linkIn, linkOut]);
const fieldTypes = new Set(['menu', 'key', 'variable', 'list', 'broadcast']);
const procedureTypes = new Set(['procedures_definition', 'procedures_call', 'procedures_call_value']);

function isValueType(type: string, catalog: Catalog): boolean | undefined {
  if (type in shadows) return true;
  const known = catalog.find(type);
  return known && valueShapes.has(known.block.shape);
}

function fieldFits(arg: PackArg, value: unknown): boolean {
  if (arg.type === 'menu') return (arg.options ?? []).some((option) => option.value === value);
  if (arg.type === 'key') return typeof value === 'string';
  return typeof value === 'object' && value !== null && typeof (value as { id?: unknown }).id === 'string';
}

function argsOf(block: PackBlock): Map<string, PackArg> {
  return new Map((block.args ?? []).map((arg) => [arg.name, arg]));
}

function inputFits(arg: PackArg | undefined, input: ConnectionState, catalog: Catalog): boolean {
  if (!arg || fieldTypes.has(arg.type)) return false;
  const child = input.block ?? input.shadow;
  if (!child) return true;
  const isValue = isValueType(child.type, catalog);
  if (isValue === undefined) return true;
  if (arg.type === 'statements') return !isValue;
  if (arg.type !== 'boolean') return isValue;
  return catalog.find(child.type)?.block.shape === 'boolean';
}

function hasParams(extra: unknown): boolean {
  if (typeof extra !== 'object' || extra === null) return false;
  const { id, name, params } = extra as Record<string, unknown>;
  return typeof id === 'string' && typeof name === 'string' && Array.isArray(params);
}

/** Number fields show numbers only: a shadow with another text would lose it. */
function shadowFits(state: BlockState): boolean {
  const fields = Object.entries(state.fields ?? {});
  if (state.next || state.inputs || fields.some(([name]) => name !== shadows[state.type])) return false;
  return fields.every(([, value]) => {
    if (state.type === 'text') return typeof value === 'string';
    return value === '' || (typeof value === 'number' && Number.isFinite(value));
  });
}

/** Whether the known block of this type can hold all of this state. */
function fits(state: BlockState, catalog: Catalog): boolean {
  if (own.has(state.type)) return true;
  if (state.type in shadows) return shadowFits(state);
  const known = catalog.find(state.type);
  if (!known) return false;
  if (procedureTypes.has(state.type)) return hasParams(state.extraState);
  if (state.type.startsWith('argument_reporter_')) return typeof state.fields?.VALUE === 'string';
  const args = argsOf(known.block);
  for (const [name, value] of Object.entries(state.fields ?? {})) {
    const arg = args.get(name);
    if (!arg || !fieldTypes.has(arg.type) || !fieldFits(arg, value)) return false;
  }
  for (const [name, input] of Object.entries(state.inputs ?? {})) {
    if (!inputFits(args.get(name), input, catalog)) return false;
  }
  const ends = endsStack(known.block) || valueShapes.has(known.block.shape);
  return !(ends && state.next);
}

/** Whether a known block of this type may stand in this place. */
function fitsPlace(type: string, role: Role, catalog: Catalog): boolean {
  if (role === 'top') return true;
  const isValue = isValueType(type, catalog);
  if (isValue === undefined) return true;
  const isHat = catalog.find(type)?.block.shape === 'hat' || type === 'procedures_definition';
  return role === 'value' ? isValue : !isValue && !isHat;
}

function kindOf(input: ConnectionState, catalog: Catalog): InputKind {
  if (input.shadow || !input.block) return 'value';
  const isValue = isValueType(input.block.type, catalog);
  if (isValue !== undefined) return isValue ? 'value' : 'statement';
  return input.block.next ? 'statement' : 'value';
}

function wrap(state: BlockState, role: Role, catalog: Catalog): BlockState {
  const keys = Object.keys(state);
  const kept: Record<string, unknown> = {};
  for (const key of keys) if (!carried.has(key)) kept[key] = state[key];
  const inputs = Object.entries(state.inputs ?? {}).map(([name, input]) => ({
    name,
    kind: kindOf(input, catalog),
  }));
  const extraState: Kept = { type: state.type, role, keys, state: kept, inputs };
  const wrapped: BlockState = { type: placeholder, extraState };
  for (const key of ['id', 'x', 'y', 'inputs', 'next'] as const) {
    if (state[key] !== undefined) (wrapped as Record<string, unknown>)[key] = state[key];
  }
  return wrapped;
}

function roleOfInput(parent: BlockState, name: string, catalog: Catalog): Role {
  if (parent.type === placeholder) {
    const kept = parent.extraState as Kept;
    return kept.inputs.find((input) => input.name === name)?.kind ?? 'value';
  }
  const args = catalog.find(parent.type)?.block.args ?? [];
  return args.find((arg) => arg.name === name)?.type === 'statements' ? 'statement' : 'value';
}

/** Puts placeholders, in place, where a block is not known or does not fit. Returns the types concerned. */
export function hideUnknown(workspace: WorkspaceState, catalog: Catalog): string[] {
  const found = new Set<string>();
  const open: { holder: { block?: BlockState }; key: 'block' | 'shadow'; role: Role }[] = [];
  const tops = workspace.blocks?.blocks ?? [];
  const settle = (state: BlockState, role: Role): BlockState => {
    const good = fits(state, catalog) && fitsPlace(state.type, role, catalog);
    if (!good) found.add(state.type);
    const settled = good ? state : wrap(state, role, catalog);
    if (settled.next) open.push({ holder: settled.next, key: 'block', role: 'statement' });
    for (const [name, input] of Object.entries(settled.inputs ?? {})) {
      const inner = roleOfInput(settled, name, catalog);
      open.push({ holder: input, key: 'block', role: inner }, { holder: input, key: 'shadow', role: inner });
    }
    return settled;
  };
  for (let i = 0; i < tops.length; i++) tops[i] = settle(tops[i]!, 'top');
  for (let link = open.pop(); link; link = open.pop()) {
    const holder = link.holder as ConnectionState;
    const state = holder[link.key];
    if (state) holder[link.key] = settle(state, link.role);
  }
  return [...found];
}

function unwrap(state: BlockState): BlockState {
  const kept = state.extraState as Kept;
  const back: Record<string, unknown> = {};
  for (const key of kept.keys) {
    const value = carried.has(key) ? state[key] : kept.state[key];
    if (value !== undefined) back[key] = value;
  }
  for (const key of ['id', 'x', 'y', 'inputs', 'next']) {
    if (!(key in back) && state[key] !== undefined) back[key] = state[key];
  }
  return back as BlockState;
}

/** The inverse of hideUnknown, in place. */
export function showUnknown(workspace: WorkspaceState): void {
  const tops = workspace.blocks?.blocks ?? [];
  const open: ConnectionState[] = [];
  const settle = (state: BlockState): BlockState => {
    const settled = state.type === placeholder ? unwrap(state) : state;
    if (settled.next) open.push(settled.next);
    open.push(...Object.values(settled.inputs ?? {}));
    return settled;
  };
  for (let i = 0; i < tops.length; i++) tops[i] = settle(tops[i]!);
  for (let link = open.pop(); link; link = open.pop()) {
    if (link.block) link.block = settle(link.block);
    if (link.shadow) link.shadow = settle(link.shadow);
  }
}

/** Names of arguments that a text does not show: the editor appends them, so nothing is lost. */
export function hiddenArgs(block: PackBlock, text: string): PackArg[] {
  const shown = new Set(cutText(text).flatMap((part) => ('arg' in part ? [part.arg] : [])));
  return (block.args ?? []).filter((arg) => !shown.has(arg.name));
}
