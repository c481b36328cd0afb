import { describe, expect, it } from 'vitest';
import { readNumber } from '../src/model/number';

describe('readNumber', () => {
  it('a decimal comma is a decimal point', () => {
    expect(readNumber('0,5')).toBe(0.5);
    expect(readNumber('-3,25')).toBe(-3.25);
    expect(readNumber('3.5')).toBe(3.5);
  });

  it('thousands may be parted in both ways', () => {
    expect(readNumber('1.000,5')).toBe(1000.5);
    expect(readNumber('1,000.5')).toBe(1000.5);
    expect(readNumber('1.000.000')).toBe(1_000_000);
    expect(readNumber('1,000,000')).toBe(1_000_000);
    expect(readNumber('12 000')).toBe(12_000);
  });

  it('what is no number, or too large to be kept, is none', () => {
    for (const text of ['1e400', 'Infinity', '-Infinity', '9'.repeat(320), 'abc', '.', '-', 'NaN'])
      expect(readNumber(text)).toBe(null);
    expect(readNumber('1e3')).toBe(1000);
    expect(readNumber('')).toBe(0);
  });
});
