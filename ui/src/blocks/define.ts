/** Makes Blockly blocks of the packs' definitions, in the current language. */
import * as Blockly from 'blockly/core';
import { say, t } from '../messages';
import { linkIn, linkOut } from '../model/chains';
import { hiddenArgs } from '../model/placeholders';
import { FieldAngle } from './field_angle';
import { FieldAmount, FieldName } from './fields';
import { keyNames, keyWords } from './keys';
import { type Known, type PackArg, type PackBlock, type Catalog, cutText, endsStack } from './pack';
import { defineProcedures, isProcedureType } from './procedure_blocks';
import { definePlaceholder } from './unknown_block';

const valueTypes = new Set(['number', 'angle', 'text', 'boolean']);

function makeField(arg: PackArg): Blockly.Field {
  switch (arg.type) {
    case 'variable':
      return new FieldName('');
    case 'list':
      return new FieldName('list');
    case 'broadcast':
      return new FieldName('broadcast_msg');
    case 'key':
      return withDefault(
        keyNames.map((key): [string, string] => [say(keyWords(key)), key]),
        arg,
      );
    default:
      return withDefault(
        (arg.options ?? []).map((o): [string, string] => [say(o.text), o.value]),
        arg,
      );
  }
}

function withDefault(options: [string, string][], arg: PackArg): Blockly.Field {
  const field = new Blockly.FieldDropdown(options.length ? options : [[' ', '']]);
  if (typeof arg.default === 'string') field.setValue(arg.default);
  return field;
}

/** Appends the sentence to the block: text and fields gather in front of the next input. */
export function appendSentence(block: Blockly.Block, definition: PackBlock): void {
  const text = say(definition.text);
  const byName = new Map((definition.args ?? []).map((arg) => [arg.name, arg]));
  const parts = [...cutText(text), ...hiddenArgs(definition, text).map((arg) => ({ arg: arg.name }))];
  let waiting: [Blockly.Field, string | undefined][] = [];
  const into = (input: Blockly.Input) => {
    for (const [field, name] of waiting) input.appendField(field, name);
    waiting = [];
  };
  for (const part of parts) {
    const arg = 'arg' in part ? byName.get(part.arg) : undefined;
    if ('text' in part) {
      if (part.text.trim()) waiting.push([new Blockly.FieldLabel(part.text.trim()), undefined]);
    } else if (!arg) {
      waiting.push([new Blockly.FieldLabel(part.arg), undefined]);
    } else if (valueTypes.has(arg.type)) {
      into(block.appendValueInput(arg.name).setCheck(arg.type === 'boolean' ? 'Boolean' : 'Value'));
    } else if (arg.type === 'statements') {
      if (waiting.length) into(block.appendDummyInput());
      block.appendStatementInput(arg.name);
    } else {
      waiting.push([makeField(arg), arg.name]);
    }
  }
  if (waiting.length) into(block.appendDummyInput());
}

/** Ends and colour of a block by its shape. */
export function applyShape(block: Blockly.Block, definition: PackBlock, style: string): void {
  const { shape } = definition;
  block.setInputsInline(true);
  block.setStyle(shape === 'hat' ? `${style}_hat` : style);
  if (shape === 'reporter') block.setOutput(true, 'Value');
  else if (shape === 'boolean') block.setOutput(true, ['Boolean', 'Value']);
  else {
    block.setPreviousStatement(shape !== 'hat');
    block.setNextStatement(!endsStack(definition));
  }
}

function defineBlock({ pack, block: definition }: Known): void {
  Blockly.Blocks[definition.opcode] = {
    init(this: Blockly.Block) {
      appendSentence(this, definition);
      applyShape(this, definition, pack.id);
      if (definition.help) this.setTooltip(() => say(definition.help));
    },
  };
}

function defineShadow(type: string, fieldName: string, make: () => Blockly.Field): void {
  Blockly.Blocks[type] = {
    init(this: Blockly.Block) {
      this.appendDummyInput().appendField(make(), fieldName);
      this.setOutput(true, 'Value');
      this.setStyle('mirada_shadow');
    },
  };
}

function defineLinks(): void {
  const label = (block: Blockly.Block, key: 'link_in' | 'link_out') => {
    const [before, after] = t(key, { n: '\n' }).split('\n');
    const input = block.appendDummyInput();
    if (before) input.appendField(before);
    input.appendField(new Blockly.FieldLabelSerializable('1'), 'LINK');
    if (after) input.appendField(after);
    block.setStyle('mirada_unknown');
  };
  Blockly.Blocks[linkOut] = {
    init(this: Blockly.Block) {
      label(this, 'link_out');
      this.setPreviousStatement(true);
    },
  };
  Blockly.Blocks[linkIn] = {
    init(this: Blockly.Block) {
      label(this, 'link_in');
      this.setNextStatement(true);
    },
  };
}

/** Defines all blocks anew; called again when the language changes, before the blocks are made again. */
export function defineBlocks(catalog: Catalog): void {
  for (const pack of catalog.packs) {
    for (const block of pack.blocks) {
      if (!isProcedureType(block.opcode)) defineBlock({ pack, block });
    }
  }
  defineShadow('math_number', 'NUM', () => new FieldAmount(0));
  defineShadow('math_angle', 'NUM', () => new FieldAngle(0));
  defineShadow('text', 'TEXT', () => new Blockly.FieldTextInput(''));
  defineLinks();
  definePlaceholder();
  defineProcedures(catalog);
}
