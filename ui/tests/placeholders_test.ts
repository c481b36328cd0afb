import { describe, expect, it } from 'vitest';
import { writeJson } from '../src/model/json';
import { hideUnknown, placeholder, showUnknown } from '../src/model/placeholders';
import { type BlockState, eachBlock } from '../src/model/program';
import { shippedCatalog, shippedExamples, stack, wait, workspaceOf } from './support';

const catalog = shippedCatalog();

function hidden(...tops: BlockState[]): { found: string[]; placeholders: number; same: boolean } {
  const workspace = workspaceOf(...tops);
  const before = writeJson(workspace);
  const found = hideUnknown(workspace, catalog);
  const placeholders = [...eachBlock(workspace)].filter((block) => block.type === placeholder).length;
  showUnknown(workspace);
  return { found, placeholders, same: writeJson(workspace) === before };
}

describe('placeholders', () => {
  it('leaves every shipped example alone', () => {
    for (const { file, text } of shippedExamples()) {
      const { workspace } = JSON.parse(text) as { workspace: ReturnType<typeof workspaceOf> };
      expect(hideUnknown(workspace, catalog), file).toEqual([]);
    }
  });

  it('keeps an unknown block in the middle of a stack, with all that it holds', () => {
    const unknown: BlockState = {
      data: 'kept',
      type: 'arm_grab',
      id: 'u',
      extraState: { a: [1, { b: null }] },
      fields: { HAND: 'left', DEEP: { x: 1 } },
      inputs: {
        FORCE: { shadow: { type: 'math_number', id: 'n', fields: { NUM: 3 } } },
        DO: { block: stack(wait('in1'), wait('in2')) },
      },
    };
    const result = hidden({ ...stack(wait('a'), unknown, wait('z')), x: 3, y: 4 });
    expect(result).toEqual({ found: ['arm_grab'], placeholders: 1, same: true });
  });

  it('keeps unknown values, hats and shadows', () => {
    const value: BlockState = {
      type: 'arm_angle',
      id: 'v',
      inputs: { A: { block: { type: 'arm_x', id: 'w' } } },
    };
    const holder: BlockState = {
      type: 'control_wait',
      id: 'h',
      inputs: { DURATION: { shadow: { type: 'odd', id: 's' }, block: value } },
    };
    const result = hidden({ type: 'arm_when', id: 'hat', x: 0, y: 0, next: { block: holder } });
    expect(result.found.sort()).toEqual(['arm_angle', 'arm_when', 'arm_x', 'odd']);
    expect(result).toMatchObject({ placeholders: 4, same: true });
  });

  it.each<[string, BlockState]>([
    ['a menu entry that is not there', { type: 'motion_turn', id: 'm', fields: { SIDE: 'upwards' } }],
    ['a field that is not there', { type: 'control_wait', id: 'm', fields: { NEW: 1 } }],
    ['an input that is not there', { type: 'control_wait', id: 'm', inputs: { NEW: { block: wait('x') } } }],
    ['a number that is none', { type: 'math_number', id: 'm', fields: { NUM: 'abc' } }],
    ['a block after a forever', { type: 'control_forever', id: 'm', next: { block: wait('x') } }],
    ['a my block without its state', { type: 'procedures_call', id: 'm' }],
    [
      'a number where a condition belongs',
      {
        type: 'control_if',
        id: 'm',
        inputs: { CONDITION: { block: { type: 'operator_add', id: 'x' } } },
      },
    ],
  ])('keeps %s', (_, block) => {
    const result = hidden({ ...block, x: 0, y: 0 });
    expect(result.placeholders).toBe(1);
    expect(result.same).toBe(true);
  });

  it('keeps a hat that stands inside a stack', () => {
    const result = hidden(stack(wait('a'), { type: 'event_whenflagclicked', id: 'h' }));
    expect(result).toEqual({ found: ['event_whenflagclicked'], placeholders: 1, same: true });
  });

  it('walks a long stack', () => {
    const list = Array.from({ length: 5000 }, (_, i) =>
      i % 2 ? wait(`b${i}`) : { type: 'odd', id: `b${i}` },
    );
    expect(hidden(stack(...list))).toEqual({ found: ['odd'], placeholders: 2500, same: true });
  });
});
