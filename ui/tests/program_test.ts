import { describe, expect, it } from 'vitest';
import { type Program, eachBlock, inLanguage, maxProgramBytes, readProgram } from '../src/model/program';
import { shippedExamples, stack, wait, workspaceOf } from './support';

const envelope = (workspace: unknown, more = {}) =>
  JSON.stringify({ format: 'mirada-program', version: 1, name: 'x', packs: [], workspace, ...more });

describe('readProgram', () => {
  it('reads every example that ships', () => {
    const examples = shippedExamples();
    expect(examples.length).toBeGreaterThan(0);
    for (const { file, text } of examples) expect(readProgram(text, 'x'), file).toHaveProperty('program');
  });

  it('reads a bare workspace under the name of its file', () => {
    const read = readProgram(JSON.stringify(workspaceOf(wait('a'))), 'my file');
    expect(read).toMatchObject({ program: { name: 'my file', format: 'mirada-program' } });
  });

  it.each([
    ['', 'file_not_json'],
    ['{"format": "mirada-program", "vers', 'file_not_json'],
    ['[]', 'file_not_program'],
    ['{}', 'file_not_program'],
    ['7', 'file_not_program'],
    [envelope(null), 'file_not_program'],
    [envelope({ blocks: { blocks: [{ id: 'no type' }] } }), 'file_not_program'],
    [envelope({ blocks: { blocks: [null] } }), 'file_not_program'],
    [envelope({ blocks: { blocks: [{ type: 'a', next: { block: 3 } }] } }), 'file_not_program'],
    [envelope({ blocks: { blocks: [{ type: 'a', inputs: { A: 'x' } }] } }), 'file_not_program'],
    [envelope({ variables: [{ name: 3 }] }), 'file_not_program'],
    [envelope({}, { version: 2 }), 'file_too_new'],
    [' '.repeat(maxProgramBytes + 1), 'file_too_big'],
  ])('says what is wrong with %.40s', (text, bad) => {
    expect(readProgram(text, 'x')).toEqual({ bad });
  });
});

describe('eachBlock', () => {
  it('visits blocks, inputs and shadows of a long stack', () => {
    const list = Array.from({ length: 20_000 }, (_, i) => wait(`b${i}`));
    const ids = [...eachBlock(workspaceOf(stack(...list)))].map((block) => block.id);
    expect(ids.length).toBe(40_000);
    expect(ids.slice(0, 3)).toEqual(['b0', 'b0s', 'b1']);
  });
});

const shipped = import.meta.glob<Program>('../../blocks/*/examples/*.json', {
  eager: true,
  import: 'default',
});

describe('an example', () => {
  it('speaks the language that the editor speaks', () => {
    expect(Object.keys(shipped).length).toBeGreaterThan(5);
    for (const [file, example] of Object.entries(shipped)) {
      const texts = [...JSON.stringify(example.workspace).matchAll(/"TEXT":"([^"]*)"/g)].map(
        (found) => found[1]!,
      );
      const spanish = JSON.stringify(inLanguage(example, 'es').workspace);
      for (const text of texts.filter((one) => /\p{L}/u.test(one))) {
        const words = example.words?.find((one) => one.en === text);
        expect(words?.es, `${file}: ${text}`).toBeTruthy();
        expect(spanish).toContain(JSON.stringify(words!.es));
        expect(spanish).not.toContain(JSON.stringify(text));
      }
      expect(inLanguage(example, 'en').workspace).toEqual(example.workspace);
    }
  });
});
