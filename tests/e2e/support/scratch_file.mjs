// Scratch projects, made here: a small project.json, and a real archive around it.
import { deflateRawSync } from 'node:zlib';

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}

/** A zip archive of {name: content}. */
export function archive(files) {
  const parts = [];
  const records = [];
  let at = 0;
  for (const [name, content] of Object.entries(files)) {
    const raw = Buffer.from(content);
    const packed = deflateRawSync(raw);
    const sizes = Buffer.alloc(12);
    sizes.writeUInt32LE(crc32(raw), 0);
    sizes.writeUInt32LE(packed.length, 4);
    sizes.writeUInt32LE(raw.length, 8);
    const head = Buffer.alloc(30);
    head.writeUInt32LE(0x04034b50, 0);
    head.writeUInt16LE(20, 4);
    head.writeUInt16LE(8, 8);
    sizes.copy(head, 14);
    head.writeUInt16LE(name.length, 26);
    const record = Buffer.alloc(46);
    record.writeUInt32LE(0x02014b50, 0);
    record.writeUInt16LE(20, 4);
    record.writeUInt16LE(20, 6);
    record.writeUInt16LE(8, 10);
    sizes.copy(record, 16);
    record.writeUInt16LE(name.length, 28);
    record.writeUInt32LE(at, 42);
    parts.push(head, Buffer.from(name), packed);
    records.push(record, Buffer.from(name));
    at += 30 + name.length + packed.length;
  }
  const directory = Buffer.concat(records);
  const end = Buffer.alloc(22);
  end.writeUInt32LE(0x06054b50, 0);
  end.writeUInt16LE(records.length / 2, 8);
  end.writeUInt16LE(records.length / 2, 10);
  end.writeUInt32LE(directory.length, 12);
  end.writeUInt32LE(at, 16);
  return Buffer.concat([...parts, directory, end]);
}

const block = (opcode, next, rest = {}) => ({
  opcode,
  next,
  parent: null,
  inputs: {},
  fields: {},
  shadow: false,
  topLevel: false,
  ...rest,
});

/** A cat that counts its lives in a variable of its own, says them, and waits; `extra` is one more block's opcode. */
export function catProject(extra) {
  const lives = { VARIABLE: ['lives', 'v'] };
  const blocks = {
    hat: block('event_whenflagclicked', 'set', { topLevel: true }),
    set: block('data_setvariableto', 'say', { inputs: { VALUE: [1, [10, '9']] }, fields: lives }),
    say: block('looks_say', extra ? 'extra' : 'loop', {
      inputs: { MESSAGE: [3, [12, 'lives', 'v'], [10, '']] },
    }),
    loop: block('control_repeat', null, { inputs: { TIMES: [1, [6, '100']], SUBSTACK: [2, 'wait'] } }),
    wait: block('control_wait', null, { inputs: { DURATION: [1, [5, '0.1']] } }),
  };
  if (extra) blocks.extra = block(extra, 'loop');
  const target = { lists: {}, broadcasts: {}, comments: {}, costumes: [], sounds: [], variables: {} };
  return JSON.stringify({
    targets: [
      { ...target, isStage: true, name: 'Stage', blocks: {}, layerOrder: 0 },
      { ...target, isStage: false, name: 'Cat', variables: { v: ['lives', 0] }, blocks, layerOrder: 1 },
    ],
    monitors: [],
    extensions: [],
    meta: { semver: '3.0.0' },
  });
}
