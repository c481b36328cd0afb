import { describe, expect, it } from 'vitest';
import { type Bytes, onlyProject } from '../src/model/scratch_file';

interface File {
  name: string;
  text: string;
}

const bytesOf = (text: string): Bytes => new TextEncoder().encode(text);

function joined(parts: Bytes[]): Bytes {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** `size` bytes, with numbers at their places: [place, bytes, number]. */
function record(size: number, numbers: [number, 2 | 4, number][]): Bytes {
  const out = new Uint8Array(size);
  const view = new DataView(out.buffer);
  for (const [place, width, number] of numbers) {
    if (width === 2) view.setUint16(place, number, true);
    else view.setUint32(place, number, true);
  }
  return out;
}

/** A real archive, its files stored as they are (without checksums: nobody here reads them). */
function archive(files: File[], comment = ''): Bytes {
  const parts: Bytes[] = [];
  const records: Bytes[] = [];
  let at = 0;
  for (const file of files) {
    const name = bytesOf(file.name);
    const text = bytesOf(file.text);
    const sizes = (from: number): [number, 2 | 4, number][] => [
      [from, 4, text.length],
      [from + 4, 4, text.length],
      [from + 8, 2, name.length],
    ];
    parts.push(record(30, [[0, 4, 0x04034b50], ...sizes(18)]), name, text);
    records.push(record(46, [[0, 4, 0x02014b50], ...sizes(20), [42, 4, at]]), name);
    at += 30 + name.length + text.length;
  }
  const directory = joined(records);
  const end = record(22, [
    [0, 4, 0x06054b50],
    [8, 2, files.length],
    [10, 2, files.length],
    [12, 4, directory.length],
    [16, 4, at],
    [20, 2, comment.length],
  ]);
  return joined([...parts, directory, end, bytesOf(comment)]);
}

/** What the only file of an archive holds. */
function unpacked(bytes: Bytes): string {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const end = bytes.length - 22;
  expect(view.getUint32(end, true)).toBe(0x06054b50);
  expect(view.getUint16(end + 10, true)).toBe(1);
  const entry = view.getUint32(end + 16, true);
  expect(entry + view.getUint32(end + 12, true)).toBe(end);
  const local = view.getUint32(entry + 42, true);
  expect(view.getUint32(local, true)).toBe(0x04034b50);
  const from = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
  return new TextDecoder().decode(bytes.subarray(from, from + view.getUint32(entry + 20, true)));
}

const project = { name: 'project.json', text: '{"targets":[]}' };
const picture = { name: '0a.svg', text: '<svg>'.repeat(1000) };

describe('a Scratch file', () => {
  it('is sent without its pictures and sounds', () => {
    for (const files of [
      [picture, project],
      [project, picture],
    ]) {
      expect(unpacked(onlyProject(archive(files)))).toBe(project.text);
    }
  });

  it('may have a comment, and its project in a folder', () => {
    expect(unpacked(onlyProject(archive([project], 'made with love')))).toBe(project.text);
    expect(unpacked(onlyProject(archive([{ ...project, name: 'My game/project.json' }])))).toBe(project.text);
  });

  it('that holds no project, or is none, goes to the robot as it is', () => {
    const others = [
      archive([picture]),
      archive([{ ...project, name: '../project.json' }]),
      bytesOf('{"targets":[]}'),
      new Uint8Array(0),
      archive([project]).subarray(0, 60),
    ];
    for (const bytes of others) expect(onlyProject(bytes)).toBe(bytes);
  });

  it('whose numbers lead nowhere is not cut', () => {
    const bytes = archive([project]);
    bytes.set([0xff, 0xff, 0xff, 0x7f], bytes.length - 22 - project.name.length - 46 + 42);
    expect(onlyProject(bytes)).toBe(bytes);
  });
});
