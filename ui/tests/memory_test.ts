import { describe, expect, it } from 'vitest';
import { attentionWords } from '../src/stage/memory';
import { drawMemory, memoryView, onCanvas, strength } from '../src/stage/memory_draw';
import type { Memory } from '../src/wire/protocol';

const robot = { x_m: 1, y_m: 2, heading_deg: 90, pan_deg: 0, hfov_deg: 62 };
const memory: Memory = {
  robot,
  places: [
    [1, 3, 0.02, 0],
    [1, 1, 0.02, 5],
  ],
  segments: [],
  things: [],
  free: [],
  next: { watching: 'nothing', why: '', pan_deg: 0, moving: false },
};

describe('the memory from above', () => {
  it('has the robot in the middle, its front up and its left to the left', () => {
    const view = memoryView(520, 520, memory);
    expect(view.scale).toBeCloseTo(100);
    const ahead = onCanvas(view, robot, [1, 3]);
    expect(ahead[0]).toBeCloseTo(260);
    expect(ahead[1]).toBeCloseTo(160);
    const left = onCanvas(view, robot, [0, 2]);
    expect(left[0]).toBeCloseTo(160);
    expect(left[1]).toBeCloseTo(260);
  });

  it('shows what is remembered farther off too', () => {
    const far: Memory = { ...memory, things: [['tag', 7, 1, 6.5, 0.1, 0]] };
    const view = memoryView(520, 520, far);
    const [x, y] = onCanvas(view, robot, [1, 6.5]);
    expect(x).toBeCloseTo(260);
    expect(y).toBeGreaterThan(0);
    expect(view.scale).toBeLessThan(memoryView(520, 520, memory).scale);
  });

  it('writes the number of a tag where the tag was seen', () => {
    const view = memoryView(520, 520, memory);
    const written: unknown[][] = [];
    const pen = new Proxy(
      {},
      {
        get:
          (_, name) =>
          (...given: unknown[]) =>
            name === 'fillText' && written.push(given),
        set: () => true,
      },
    );
    drawMemory(
      pen as CanvasRenderingContext2D,
      view,
      {
        ...memory,
        things: [
          ['tag', 7, 1, 3, 0.1, 0],
          ['face', 0, 1, 1, 0.1, 0],
        ],
      },
      '#9966ff',
    );
    expect(written).toContainEqual(['7', 260, expect.closeTo(160)]);
  });

  it('fades with age, and never quite away', () => {
    expect(strength(0)).toBe(1);
    expect(strength(10)).toBeLessThan(1);
    expect(strength(10)).toBeGreaterThan(strength(30));
    expect(strength(1000)).toBeCloseTo(0.18);
  });

  it('says why attention looks where it looks, else how much is remembered', () => {
    expect(attentionWords(null)).toBe('');
    expect(attentionWords(memory)).toContain('2');
    const old = { ...memory, next: { ...memory.next, watching: 'around', why: 'old' } };
    expect(attentionWords(old)).not.toBe(attentionWords(memory));
  });
});
