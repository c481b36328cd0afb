import { describe, expect, it } from 'vitest';
import { fill, tables } from '../src/messages';
import { en } from '../src/messages/en';
import { shippedCatalog } from './support';

const holes = (text: string) => (text.match(/\{\w+\}/g) ?? []).sort();

describe('messages', () => {
  it('say the same things with the same values in every language', () => {
    for (const [code, table] of Object.entries(tables)) {
      expect(Object.keys(table).sort(), code).toEqual(Object.keys(en).sort());
      for (const [key, text] of Object.entries(table)) {
        expect(text.trim(), `${code} ${key}`).not.toBe('');
        expect(holes(text), `${code} ${key}`).toEqual(holes(en[key as keyof typeof en]));
      }
    }
  });

  it('fills values in and leaves unknown holes', () => {
    expect(fill('{n} of {max} {x}', { n: 1, max: 2 })).toBe('1 of 2 {x}');
  });

  it('every block shows the same arguments in every language', () => {
    for (const pack of shippedCatalog().packs) {
      for (const { opcode, text } of pack.blocks) {
        const names = (words: string) => (words.match(/\[\w+\]/g) ?? []).sort();
        expect(names(text.es), opcode).toEqual(names(text.en));
      }
    }
  });
});
