/** My blocks: typed, frame-local parameters, a return value, warp (docs/program-format.md). */
import * as Blockly from 'blockly/core';
import { editProcedure } from '../dialogs/procedure_dialog';
import { say, t } from '../messages';
import type { Catalog } from './pack';

export type ParamType = 'number' | 'text' | 'boolean';

export interface Param {
  id: string;
  name: string;
  type: ParamType;
}

export interface Procedure {
  id: string;
  name: string;
  params: Param[];
  returns: boolean;
  warp: boolean;
}

export interface ProcedureBlock extends Blockly.Block {
  procedure: Procedure;
  rebuild(): void;
}

export const definitionType = 'procedures_definition';
export const callType = 'procedures_call';
export const callValueType = 'procedures_call_value';
const argumentTypes = ['argument_reporter_string_number', 'argument_reporter_boolean'];
const builtHere = new Set([definitionType, callType, callValueType, ...argumentTypes]);
const pencil =
  'data:image/svg+xml,' +
  encodeURIComponent(
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path fill="#fff" d="M4 16.500V20h3.500L18 9.500 14.500 6zM20.700 6.800a1 1 0 0 0 0-1.400l-2.100-2.100a1 1 0 0 0-1.400 0l-1.600 1.600 3.500 3.500z"/></svg>',
  );

/** Whether this module makes the block, rather than its pack's sentence. */
export function isProcedureType(opcode: string): boolean {
  return builtHere.has(opcode);
}

export function argumentTypeOf(type: ParamType): string {
  return type === 'boolean' ? 'argument_reporter_boolean' : 'argument_reporter_string_number';
}

export function shadowFor(type: ParamType): { type: string; fields: Record<string, unknown> } | null {
  if (type === 'boolean') return null;
  return type === 'text'
    ? { type: 'text', fields: { TEXT: '' } }
    : { type: 'math_number', fields: { NUM: 0 } };
}

function clearInputs(block: Blockly.Block): Map<string, Blockly.Block> {
  const held = new Map<string, Blockly.Block>();
  for (const input of [...block.inputList]) {
    const child = input.connection?.targetBlock();
    if (child && !child.isShadow()) {
      held.set(input.name, child);
      input.connection?.setShadowState(null);
      child.outputConnection?.disconnect();
    }
    block.removeInput(input.name, true);
  }
  return held;
}

function buildDefinition(this: ProcedureBlock): void {
  clearInputs(this);
  const { name, params, warp } = this.procedure;
  const head = this.appendDummyInput('HEAD');
  head.appendField(t('define')).appendField(name);
  for (const param of params) {
    const chip = new Blockly.FieldLabel(param.name, `mirada-chip mirada-chip-${param.type}`);
    head.appendField(chip);
  }
  if (warp) head.appendField(t('at_once_mark'));
  const edit = () => editProcedure(this.workspace as Blockly.WorkspaceSvg, this);
  head.appendField(new Blockly.FieldImage(pencil, 20, 20, t('edit_block'), edit));
}

function buildCall(this: ProcedureBlock): void {
  const held = clearInputs(this);
  const { name, params } = this.procedure;
  if (params.length === 0) this.appendDummyInput('HEAD').appendField(name);
  params.forEach((param, index) => {
    const input = this.appendValueInput(param.id);
    if (index === 0) input.appendField(name);
    input.setCheck(param.type === 'boolean' ? 'Boolean' : 'Value');
    const shadow = shadowFor(param.type);
    if (shadow && !this.isInFlyout) input.connection?.setShadowState(shadow);
    const child = held.get(param.id);
    if (child?.outputConnection && input.connection) {
      const fits = input.connection
        .getConnectionChecker()
        .canConnect(child.outputConnection, input.connection, false);
      if (fits) input.connection.connect(child.outputConnection);
    }
  });
}

function stateful(rebuild: (this: ProcedureBlock) => void, init: (this: Blockly.Block) => void) {
  return {
    init,
    rebuild,
    loadExtraState(this: ProcedureBlock, state: Procedure) {
      this.procedure = { ...state, params: state.params.map((param) => ({ ...param })) };
      this.rebuild();
    },
    saveExtraState(this: ProcedureBlock) {
      return this.procedure;
    },
  };
}

function defineArgument(type: string, output: string | string[], pack: string): void {
  Blockly.Blocks[type] = {
    init(this: Blockly.Block) {
      this.appendDummyInput().appendField(new Blockly.FieldLabelSerializable('?'), 'VALUE');
      this.setOutput(true, output);
      this.setStyle(pack);
    },
  };
}

export function defineProcedures(catalog: Catalog): void {
  const known = catalog.find(definitionType);
  const style = known?.pack.id ?? 'mirada_unknown';
  const help = () => say(known?.block.help);
  Blockly.Blocks[definitionType] = stateful(buildDefinition, function () {
    this.setNextStatement(true);
    this.setStyle(`${style}_hat`);
    this.setTooltip(help);
  });
  Blockly.Blocks[callType] = stateful(buildCall, function () {
    this.setInputsInline(true);
    this.setPreviousStatement(true);
    this.setNextStatement(true);
    this.setStyle(style);
  });
  Blockly.Blocks[callValueType] = stateful(buildCall, function () {
    this.setInputsInline(true);
    this.setOutput(true, 'Value');
    this.setStyle(style);
  });
  defineArgument(argumentTypes[0]!, 'Value', style);
  defineArgument(argumentTypes[1]!, ['Boolean', 'Value'], style);
}

export function procedureBlocks(workspace: Blockly.Workspace, types: string[]): ProcedureBlock[] {
  return types.flatMap((type) => workspace.getBlocksByType(type, true)) as ProcedureBlock[];
}

export function setProcedure(block: ProcedureBlock, procedure: Procedure): void {
  const before = JSON.stringify(block.saveExtraState?.());
  const after = JSON.stringify(procedure);
  if (before === after) return;
  block.loadExtraState?.(procedure);
  Blockly.Events.fire(
    new (Blockly.Events.get(Blockly.Events.BLOCK_CHANGE))(block, 'mutation', null, before, after),
  );
}

/** Changes a definition and everything that uses it, as one step of undo. */
export function changeProcedure(
  workspace: Blockly.Workspace,
  definition: ProcedureBlock,
  after: Procedure,
): void {
  const before = definition.procedure;
  Blockly.Events.setGroup(true);
  setProcedure(definition, after);
  const calls = procedureBlocks(workspace, [callType, callValueType]);
  for (const call of calls) if (call.procedure.id === after.id) setProcedure(call, after);
  for (const param of after.params) {
    const old = before.params.find((other) => other.id === param.id);
    if (old && old.name !== param.name) renameArgument(definition, old.name, param.name);
  }
  Blockly.Events.setGroup(false);
}

function renameArgument(definition: ProcedureBlock, from: string, to: string): void {
  for (const block of definition.getDescendants(false)) {
    if (argumentTypes.includes(block.type) && block.getFieldValue('VALUE') === from)
      block.setFieldValue(to, 'VALUE');
  }
}
