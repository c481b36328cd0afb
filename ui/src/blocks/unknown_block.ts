import * as Blockly from 'blockly/core';
import { t } from '../messages';
import { type Kept, placeholder } from '../model/placeholders';

interface UnknownBlock extends Blockly.Block {
  kept: Kept;
}

function words(value: unknown): string {
  const text = typeof value === 'string' ? value : JSON.stringify(value);
  return text.length > 24 ? `${text.slice(0, 23)}…` : text;
}

function build(block: UnknownBlock): void {
  const { kept } = block;
  const head = block.appendDummyInput().appendField(t('unknown_block', { type: kept.type }));
  for (const [name, value] of Object.entries((kept.state.fields as Record<string, unknown>) ?? {})) {
    head.appendField(`${name}: ${words(value)}`);
  }
  for (const { name, kind } of kept.inputs) {
    if (kind === 'statement') block.appendStatementInput(name).appendField(name);
    else block.appendValueInput(name).appendField(name);
  }
  block.setInputsInline(true);
  block.setStyle('mirada_unknown');
  if (kept.role === 'value') {
    block.setOutput(true, null);
  } else {
    block.setPreviousStatement(true);
    block.setNextStatement(true);
  }
}

/** The grey block that stands for one that is not known here; it keeps what it holds. */
export function definePlaceholder(): void {
  Blockly.Blocks[placeholder] = {
    loadExtraState(this: UnknownBlock, state: Kept) {
      this.kept = state;
      build(this);
    },
    saveExtraState(this: UnknownBlock) {
      return this.kept;
    },
  };
}
