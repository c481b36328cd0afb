import { describe, expect, it } from 'vitest';
import { writeJson } from '../src/model/json';

describe('writeJson', () => {
  it('writes what JSON.stringify writes', () => {
    const values = [
      null,
      1.5,
      'a"\n',
      true,
      [],
      {},
      [1, [2, { a: undefined, b: [undefined, null] }]],
      { a: { b: { c: 'ñ' } }, d: undefined, e: [{}], 'ke"y': NaN },
    ];
    for (const value of values) expect(writeJson(value)).toBe(JSON.stringify(value));
  });

  it('writes nesting far deeper than a call stack', () => {
    let deep: unknown = 'end';
    for (let i = 0; i < 60_000; i++) deep = { next: { block: deep } };
    const text = writeJson(deep);
    expect(text.length).toBe('{"next":{"block":}}'.length * 60_000 + '"end"'.length);
    expect(text.endsWith('"end"' + '}'.repeat(120_000))).toBe(true);
  });
});
