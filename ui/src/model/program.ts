import type { Lang, Words } from './words';
/** The program as it travels (docs/program-format.md) and what can be said about it without Blockly. */

export interface ConnectionState {
  shadow?: BlockState;
  block?: BlockState;
}

export interface BlockState {
  type: string;
  id?: string;
  x?: number;
  y?: number;
  fields?: Record<string, unknown>;
  inputs?: Record<string, ConnectionState>;
  next?: ConnectionState;
  extraState?: unknown;
  data?: string;
  [other: string]: unknown;
}

export interface VariableState {
  name: string;
  id: string;
  type?: string;
}

export interface WorkspaceState {
  blocks?: { languageVersion: number; blocks: BlockState[] };
  variables?: VariableState[];
  [other: string]: unknown;
}

export interface Program {
  format: 'mirada-program';
  version: 1;
  name: string;
  packs: string[];
  workspace: WorkspaceState;
  /** Of an example: each of its texts as it stands in the program (en), and in the other languages. */
  words?: Words[];
}

/** An example with its texts in this language. */
export function inLanguage(program: Program, language: Lang): Program {
  const words = new Map(program.words?.map((one) => [one.en, one[language] ?? one.en]));
  const said = (key: string, value: unknown): unknown =>
    key === 'TEXT' && typeof value === 'string' ? (words.get(value) ?? value) : value;
  return { ...program, workspace: JSON.parse(JSON.stringify(program.workspace), said) as WorkspaceState };
}

export const maxProgramBytes = 4 * 1024 * 1024;

/** Every block of a workspace, shadows too, without recursion. */
export function* eachBlock(workspace: WorkspaceState): Generator<BlockState> {
  const open: BlockState[] = [...(workspace.blocks?.blocks ?? [])].reverse();
  for (let block = open.pop(); block; block = open.pop()) {
    yield block;
    const inner: (BlockState | undefined)[] = [block.next?.block, block.next?.shadow];
    for (const input of Object.values(block.inputs ?? {}).reverse()) inner.push(input.block, input.shadow);
    for (const child of inner) if (child) open.push(child);
  }
}

export type BadFile = 'file_not_json' | 'file_not_program' | 'file_too_new' | 'file_too_big';

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function isConnection(value: unknown): value is ConnectionState {
  return (
    isObject(value) && [value.block, value.shadow].every((inner) => inner === undefined || isObject(inner))
  );
}

function hasBlockShape(block: BlockState): boolean {
  if (typeof block.type !== 'string' || block.type === '') return false;
  if (block.id !== undefined && typeof block.id !== 'string') return false;
  if (block.fields !== undefined && !isObject(block.fields)) return false;
  if (block.next !== undefined && !isConnection(block.next)) return false;
  if (block.inputs === undefined) return true;
  return isObject(block.inputs) && Object.values(block.inputs).every(isConnection);
}

function isVariable(value: unknown): boolean {
  return isObject(value) && typeof value.name === 'string' && typeof value.id === 'string';
}

/** Whether this can be walked as a workspace: every block has a type, every connection holds blocks. */
export function isWorkspace(value: unknown): value is WorkspaceState {
  if (!isObject(value)) return false;
  const variables = value.variables;
  if (variables !== undefined && !(Array.isArray(variables) && variables.every(isVariable))) return false;
  if (value.blocks === undefined) return true;
  if (!isObject(value.blocks) || !Array.isArray(value.blocks.blocks)) return false;
  if (!value.blocks.blocks.every(isObject)) return false;
  const open = [...(value.blocks.blocks as BlockState[])];
  for (let block = open.pop(); block; block = open.pop()) {
    if (!hasBlockShape(block)) return false;
    for (const link of [block.next, ...Object.values(block.inputs ?? {})]) {
      if (link?.block) open.push(link.block);
      if (link?.shadow) open.push(link.shadow);
    }
  }
  return true;
}

/** Reads the text of a file: an envelope, or a bare workspace as Blockly writes it. */
export function readProgram(text: string, fallbackName: string): { program: Program } | { bad: BadFile } {
  if (text.length > maxProgramBytes) return { bad: 'file_too_big' };
  let value: unknown;
  try {
    value = JSON.parse(text.replace(/^\uFEFF/, ''));
  } catch {
    return { bad: 'file_not_json' };
  }
  if (!isObject(value)) return { bad: 'file_not_program' };
  if (value.format === undefined && isObject(value.blocks) && isWorkspace(value)) {
    return { program: makeProgram(fallbackName, value, []) };
  }
  if (value.format !== 'mirada-program') return { bad: 'file_not_program' };
  if (typeof value.version === 'number' && value.version > 1) return { bad: 'file_too_new' };
  if (!isWorkspace(value.workspace)) return { bad: 'file_not_program' };
  const name = typeof value.name === 'string' && value.name.trim() ? value.name : fallbackName;
  const packs = Array.isArray(value.packs)
    ? value.packs.filter((p): p is string => typeof p === 'string')
    : [];
  return { program: makeProgram(name, value.workspace, packs) };
}

export function makeProgram(name: string, workspace: WorkspaceState, packs: string[]): Program {
  return { format: 'mirada-program', version: 1, name, packs, workspace };
}
