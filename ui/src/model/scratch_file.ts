/**
 * A Scratch file (.sb3) is a zip archive with the project and all its pictures and sounds. The robot wants the project
 * only: this makes a small archive of it, without unpacking anything.
 */

/** Bytes that can be sent. */
export type Bytes = Uint8Array<ArrayBuffer>;

const localMark = 0x04034b50;
const entryMark = 0x02014b50;
const endMark = 0x06054b50;
const projectName = /^(?:[^./\\][^/\\]*\/)?project\.json$/;

interface Entry {
  name: Bytes;
  /** The central directory's record as it came. */
  record: Bytes;
  packed: number;
  offset: number;
}

/** The records of the central directory; empty when there is none. */
function entriesOf(bytes: Bytes): Entry[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const earliest = Math.max(0, bytes.length - 22 - 0xffff);
  let end = bytes.length - 22;
  while (end >= earliest && view.getUint32(end, true) !== endMark) end--;
  if (end < earliest || end < 0) return [];
  const count = view.getUint16(end + 10, true);
  const entries: Entry[] = [];
  let at = view.getUint32(end + 16, true);
  for (let i = 0; i < count && at + 46 <= end && view.getUint32(at, true) === entryMark; i++) {
    const nameLength = view.getUint16(at + 28, true);
    const next = at + 46 + nameLength + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    if (next > end) break;
    entries.push({
      name: bytes.subarray(at + 46, at + 46 + nameLength),
      record: bytes.subarray(at, next),
      packed: view.getUint32(at + 20, true),
      offset: view.getUint32(at + 42, true),
    });
    at = next;
  }
  return entries;
}

/** The part of the archive that holds one file: its local header and its packed bytes; null when it is cut off. */
function partOf(bytes: Bytes, entry: Entry): Bytes | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const { offset, packed } = entry;
  if (offset + 30 > bytes.length || view.getUint32(offset, true) !== localMark) return null;
  const head = 30 + view.getUint16(offset + 26, true) + view.getUint16(offset + 28, true);
  const end = offset + head + packed;
  return end <= bytes.length ? bytes.subarray(offset, end) : null;
}

/** An archive of project.json alone; what is no such archive comes back as it is, for the robot to say why. */
export function onlyProject(bytes: Bytes): Bytes {
  if (bytes.length < 4 || bytes[0] !== 0x50 || bytes[1] !== 0x4b) return bytes;
  const entry = entriesOf(bytes).find(({ name }) => projectName.test(new TextDecoder().decode(name)));
  const part = entry && partOf(bytes, entry);
  if (!entry || !part) return bytes;
  const out = new Uint8Array(part.length + entry.record.length + 22);
  out.set(part, 0);
  out.set(entry.record, part.length);
  const view = new DataView(out.buffer);
  view.setUint32(part.length + 42, 0, true);
  const end = part.length + entry.record.length;
  view.setUint32(end, endMark, true);
  view.setUint16(end + 8, 1, true);
  view.setUint16(end + 10, 1, true);
  view.setUint32(end + 12, entry.record.length, true);
  view.setUint32(end + 16, part.length, true);
  return out;
}
