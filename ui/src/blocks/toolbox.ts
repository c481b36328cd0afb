/** The toolbox: a category a pack, with dynamic contents where a pack works on names or on my blocks. */
import type * as Blockly from 'blockly/core';
import { say, t } from '../messages';
import type { BlockState } from '../model/program';
import type { Catalog, Pack, PackArg, PackBlock } from './pack';
import { makeProcedure } from '../dialogs/procedure_dialog';
import { askNewName } from './names';
import {
  argumentTypeOf,
  callType,
  callValueType,
  definitionType,
  isProcedureType,
  procedureBlocks,
  shadowFor,
} from './procedure_blocks';

type Item = Record<string, unknown> & { kind: string };

const shadowTypes: Partial<Record<PackArg['type'], { type: string; field: string }>> = {
  number: { type: 'math_number', field: 'NUM' },
  angle: { type: 'math_angle', field: 'NUM' },
  text: { type: 'text', field: 'TEXT' },
};

function shadowOf(arg: PackArg): BlockState | null {
  const shadow = shadowTypes[arg.type];
  if (!shadow) return null;
  const fallback = arg.type === 'text' ? '' : 0;
  const value = typeof arg.default === 'object' ? say(arg.default) : (arg.default ?? fallback);
  return { type: shadow.type, fields: { [shadow.field]: value } };
}

/** A block as it lies in the toolbox: with shadows that hold the defaults. */
export function toolboxBlock(block: PackBlock): BlockState {
  const inputs: Record<string, { shadow: BlockState }> = {};
  for (const arg of block.args ?? []) {
    const shadow = shadowOf(arg);
    if (shadow) inputs[arg.name] = { shadow };
  }
  return { type: block.opcode, ...(Object.keys(inputs).length ? { inputs } : {}) };
}

function item(block: PackBlock): Item {
  return { kind: 'block', ...toolboxBlock(block) };
}

function works(block: PackBlock, type: PackArg['type']): boolean {
  return (block.args ?? []).some((arg) => arg.type === type);
}

function inToolbox(pack: Pack): PackBlock[] {
  return pack.blocks.filter((block) => block.toolbox !== false && !isProcedureType(block.opcode));
}

/** The pack that a variable or list itself comes from: its category makes and shows the names. */
const hasNames = (pack: Pack) => inToolbox(pack).some((block) => block.shape === 'reporter' && isBare(block));
const hasProcedures = (pack: Pack) => pack.blocks.some((block) => block.opcode === definitionType);

/** One reporter for each name, then the other blocks set to the newest name. */
function nameItems(workspace: Blockly.WorkspaceSvg, pack: Pack, type: 'variable' | 'list'): Item[] {
  const kinds = workspace.getVariableMap();
  const names = kinds.getVariablesOfType(type === 'list' ? 'list' : '');
  const hasLists = kinds.getVariablesOfType('list').length > 0;
  const shown = (block: PackBlock) =>
    type === 'list' ? !works(block, 'variable') : hasLists || !works(block, 'list');
  const blocks = inToolbox(pack).filter((block) => works(block, type) && shown(block));
  if (blocks.length === 0 || names.length === 0) return [];
  const field = (block: PackBlock) => block.args!.find((arg) => arg.type === type)!.name;
  const made = (block: PackBlock, id: string): Item => ({
    ...item(block),
    fields: { [field(block)]: { id } },
  });
  const isName = (block: PackBlock) =>
    block.shape === 'reporter' && block.args!.length === 1 && isBare(block);
  const sorted = [...names].sort((a, b) => a.getName().localeCompare(b.getName()));
  const reporters = blocks.filter(isName).flatMap((block) => sorted.map((name) => made(block, name.getId())));
  const last = names.at(-1)!.getId();
  return [...reporters, ...blocks.filter((block) => !isName(block)).map((block) => made(block, last))];
}

/** A block whose sentence is nothing but its one argument: the variable or the list itself. */
function isBare(block: PackBlock): boolean {
  return /^\[\w+\]$/.test(block.text.en.trim());
}

function nameContents(workspace: Blockly.WorkspaceSvg, pack: Pack): Item[] {
  const others = inToolbox(pack).filter((block) => !works(block, 'variable') && !works(block, 'list'));
  return [
    { kind: 'button', text: t('new_variable'), callbackkey: 'new_variable' },
    ...nameItems(workspace, pack, 'variable'),
    { kind: 'button', text: t('new_list'), callbackkey: 'new_list' },
    ...nameItems(workspace, pack, 'list'),
    ...others.map(item),
  ];
}

function procedureContents(workspace: Blockly.WorkspaceSvg, pack: Pack): Item[] {
  const items: Item[] = [{ kind: 'button', text: t('new_block'), callbackkey: 'new_block' }];
  const definitions = procedureBlocks(workspace, [definitionType]);
  for (const { procedure } of definitions) {
    const inputs: Record<string, unknown> = {};
    for (const param of procedure.params) {
      const shadow = shadowFor(param.type);
      if (shadow) inputs[param.id] = { shadow };
    }
    const type = procedure.returns ? callValueType : callType;
    items.push({ kind: 'block', type, extraState: procedure, inputs });
    for (const param of procedure.params) {
      items.push({ kind: 'block', type: argumentTypeOf(param.type), fields: { VALUE: param.name } });
    }
  }
  if (definitions.length > 0) items.push(...inToolbox(pack).map(item));
  return items;
}

function category(pack: Pack): Item {
  const head = { kind: 'category', name: say(pack.name), categorystyle: pack.id, toolboxitemid: pack.id };
  if (hasNames(pack) || hasProcedures(pack)) return { ...head, custom: `pack_${pack.id}` };
  return { ...head, contents: inToolbox(pack).map(item) };
}

/** The definition of the toolbox in the current language. */
export function makeToolbox(catalog: Catalog): Blockly.utils.toolbox.ToolboxInfo {
  const contents = catalog.packs
    .filter((pack) => inToolbox(pack).length > 0 || hasProcedures(pack))
    .map(category);
  return { kind: 'categoryToolbox', contents };
}

/** Registers what the dynamic categories and the buttons do. */
export function serveToolbox(workspace: Blockly.WorkspaceSvg, catalog: Catalog): void {
  for (const pack of catalog.packs) {
    const contents = hasProcedures(pack) ? procedureContents : nameContents;
    if (!hasNames(pack) && !hasProcedures(pack)) continue;
    workspace.registerToolboxCategoryCallback(`pack_${pack.id}`, () => contents(workspace, pack));
  }
  const refresh = () => workspace.refreshToolboxSelection();
  workspace.registerButtonCallback('new_variable', () => askNewName(workspace, '', refresh));
  workspace.registerButtonCallback('new_list', () => askNewName(workspace, 'list', refresh));
  workspace.registerButtonCallback('new_block', () => makeProcedure(workspace));
}

/** Text to search in: lower case, without accents. */
export function plain(text: string): string {
  return text
    .normalize('NFD')
    .replace(/[\u0300-\u036f]/g, '')
    .toLowerCase();
}

function searchText(pack: Pack, block: PackBlock): string {
  const options = (block.args ?? []).flatMap((arg) => (arg.options ?? []).map((option) => say(option.text)));
  return plain([say(block.text).replace(/\[\w+\]/g, ' '), say(pack.name), ...options].join(' '));
}

/** The toolbox blocks that have all words of the query, in all packs; names and my blocks are found by category. */
export function searchBlocks(catalog: Catalog, query: string): PackBlock[] {
  const words = plain(query).split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  return catalog.packs.flatMap((pack) =>
    inToolbox(pack).filter((block) => {
      const text = searchText(pack, block);
      return words.every((word) => text.includes(word));
    }),
  );
}

/** What the flyout shows for a search. */
export function searchContents(workspace: Blockly.WorkspaceSvg, catalog: Catalog, query: string): Item[] {
  const found = searchBlocks(catalog, query).filter((block) => {
    const needed = (block.args ?? []).find((arg) => arg.type === 'variable' || arg.type === 'list');
    if (!needed) return true;
    return workspace.getVariableMap().getVariablesOfType(needed.type === 'list' ? 'list' : '').length > 0;
  });
  if (found.length === 0) return [{ kind: 'label', text: t('search_none') }];
  return found.map((block) => {
    const named = (block.args ?? []).find((arg) => arg.type === 'variable' || arg.type === 'list');
    if (!named) return item(block);
    const names = workspace.getVariableMap().getVariablesOfType(named.type === 'list' ? 'list' : '');
    return { ...item(block), fields: { [named.name]: { id: names.at(-1)!.getId() } } };
  });
}
