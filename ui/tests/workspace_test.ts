import * as Blockly from 'blockly/core';
import { beforeAll, describe, expect, it } from 'vitest';
import { defineBlocks } from '../src/blocks/define';
import { changeProcedure, type Procedure, procedureBlocks } from '../src/blocks/procedure_blocks';
import { loadWorkspace, saveWorkspace } from '../src/canvas/load_save';
import { lang } from '../src/messages';
import { writeJson } from '../src/model/json';
import { type BlockState, type WorkspaceState } from '../src/model/program';
import { useNoPage } from './headless';
import { shippedCatalog, shippedExamples, stack, wait, workspaceOf } from './support';

const catalog = shippedCatalog();

function roundTrip(state: WorkspaceState): WorkspaceState {
  const workspace = new Blockly.Workspace();
  loadWorkspace(workspace, state, catalog);
  const saved = saveWorkspace(workspace);
  workspace.dispose();
  return saved;
}

beforeAll(() => {
  useNoPage();
  defineBlocks(catalog);
});

describe('program to workspace and back', () => {
  it.each(shippedExamples().map(({ file, text }) => [file.split('/').pop()!, text]))('%s', (_, text) => {
    const { workspace } = JSON.parse(text) as { workspace: WorkspaceState };
    expect(roundTrip(workspace).blocks).toEqual(workspace.blocks);
  });

  it('5,000 blocks in one stack come back in order', () => {
    const list = Array.from({ length: 5000 }, (_, i) => wait(`b${i}`, i));
    const { type, id, ...rest } = stack(...list);
    const state = workspaceOf({ type, id, x: 10, y: 20, ...rest });
    const same = writeJson(roundTrip(state)) === writeJson(state);
    expect(same).toBe(true);
  });

  it('an unknown block in the middle keeps all, and what follows it stays', () => {
    const unknown: BlockState = {
      type: 'arm_grab',
      id: 'u',
      extraState: { n: 1 },
      fields: { HAND: 'left' },
      inputs: {
        FORCE: { shadow: { type: 'math_number', id: 'n', fields: { NUM: 3 } } },
        DO: { block: wait('in') },
      },
    };
    const state = workspaceOf({ ...stack(wait('a'), unknown, wait('z')), x: 1, y: 2 });
    expect(writeJson(roundTrip(state).blocks)).not.toContain('mirada_unknown');
    expect(roundTrip(state).blocks).toEqual(state.blocks);
  });

  it('a program that Blockly cannot connect becomes placeholders as a whole, and comes back as it was', () => {
    const param = { id: 'p', name: 'loud', type: 'boolean' };
    const extraState = { id: 'x', name: 'sing', params: [param], returns: false, warp: false };
    const number: BlockState = { type: 'operator_add', id: 'n' };
    const call: BlockState = {
      type: 'procedures_call',
      id: 'c',
      extraState,
      inputs: { p: { block: number } },
    };
    const state = workspaceOf({ ...stack(wait('a'), call, wait('z')), x: 1, y: 2 });
    expect(roundTrip(state).blocks).toEqual(state.blocks);
  });

  it('every shipped block survives in both languages', () => {
    for (const code of ['en', 'es'] as const) {
      lang.value = code;
      defineBlocks(catalog);
      for (const pack of catalog.packs) {
        for (const block of pack.blocks) {
          if (block.opcode.startsWith('procedures_call') || block.opcode === 'procedures_definition')
            continue;
          const workspace = new Blockly.Workspace();
          const made = workspace.newBlock(block.opcode);
          for (const arg of block.args ?? []) {
            const there = made.getInput(arg.name) ?? made.getField(arg.name);
            expect(there, `${block.opcode} ${code} ${arg.name}`).not.toBeNull();
          }
          workspace.dispose();
        }
      }
    }
    lang.value = 'en';
  });
});

const dance: Procedure = {
  id: 'p1',
  name: 'dance',
  returns: false,
  warp: true,
  params: [
    { id: 'a', name: 'steps', type: 'number' },
    { id: 'b', name: 'loud', type: 'boolean' },
  ],
};

function danceProgram(): WorkspaceState {
  const shadow = { type: 'math_number', id: 's', fields: { NUM: 4 } };
  const argument: BlockState = {
    type: 'argument_reporter_string_number',
    id: 'r',
    fields: { VALUE: 'steps' },
  };
  const body: BlockState = {
    type: 'control_wait',
    id: 'w',
    inputs: { DURATION: { shadow, block: argument } },
  };
  const loud: BlockState = { type: 'operator_not', id: 'o' };
  return workspaceOf(
    { type: 'procedures_definition', id: 'd', x: 0, y: 0, extraState: dance, next: { block: body } },
    {
      type: 'procedures_call',
      id: 'c',
      x: 0,
      y: 200,
      extraState: dance,
      inputs: { a: { shadow: { ...shadow, id: 's2' } }, b: { block: loud } },
    },
  );
}

describe.skipIf(!catalog.find('procedures_definition'))('my blocks', () => {
  it('come back as they were', () => {
    const state = danceProgram();
    expect(roundTrip(state).blocks).toEqual(state.blocks);
  });

  it('a changed parameter list keeps what fits and renames the arguments', () => {
    const workspace = new Blockly.Workspace();
    loadWorkspace(workspace, danceProgram(), catalog);
    const definition = procedureBlocks(workspace, ['procedures_definition'])[0]!;
    const after: Procedure = {
      ...dance,
      name: 'jump',
      params: [
        { id: 'b', name: 'loud', type: 'boolean' },
        { id: 'a', name: 'times', type: 'number' },
      ],
    };
    changeProcedure(workspace, definition, after);
    const call = workspace.getBlockById('c')!;
    expect(call.inputList.map((input) => input.name)).toEqual(['b', 'a']);
    expect(call.getInputTargetBlock('b')?.id).toBe('o');
    expect(call.getInputTargetBlock('a')?.type).toBe('math_number');
    expect(workspace.getBlockById('r')?.getFieldValue('VALUE')).toBe('times');
    expect((call.saveExtraState?.() as Procedure).name).toBe('jump');
    workspace.dispose();
  });
});
