// Who includes whom, against the table of docs/house.md.
import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { test } from 'node:test';
import { exists, files, isCpp, layering, lineOf, read, roomOf, root, withoutComments } from './lib.mjs';

const table = layering(read('docs/house.md'));
const sources = files.filter((path) => isCpp(path) && /^(runtime|blocks|src)\//.test(path));

/** A room may be called as a header of the standard library is: only files count. */
const isFile = (path) => exists(path) && statSync(join(root, path)).isFile();

/** Every #include with the file of ours that it means, or none for what is not ours. */
function includesOf(path) {
  const text = withoutComments(read(path));
  return [...text.matchAll(/^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]/gm)].map((match) => {
    const [, quote, name] = match;
    const candidates = [join(dirname(path), name), join('runtime', name), name].map(normalize);
    return { quote, name, line: lineOf(text, match.index), target: candidates.find((c) => isFile(c)) };
  });
}

const everyInclude = sources.flatMap((path) => includesOf(path).map((include) => ({ path, ...include })));
const where = ({ path, line, name }) => `${path}:${line} includes ${name}`;

test('the table names every room', () => {
  const rooms = readdirSync(join(root, 'runtime'), { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map((entry) => `runtime/${entry.name}`);
  assert.ok(table.size >= 12, 'the table of docs/house.md was not found');
  assert.deepEqual([...rooms, 'blocks', 'src'].filter((room) => !table.has(room)), []);
});

test('no room can be reached from itself: the layers have no circle', () => {
  const below = (room, path) => {
    assert.ok(!path.includes(room), `circle: ${[...path, room].join(' -> ')}`);
    for (const next of table.get(room) ?? []) if (next !== room) below(next, [...path, room]);
  };
  for (const room of table.keys()) below(room, []);
});

test('every include is allowed by the table', () => {
  const forbidden = everyInclude.filter(({ path, target }) => {
    if (!target) return false;
    const from = roomOf(path, table);
    const to = roomOf(target, table);
    return !from || !to || !table.get(from).has(to);
  });
  assert.deepEqual(forbidden.map(where), []);
});

test('what is ours is included in quotes and exists', () => {
  const wrong = everyInclude.filter(({ quote, name, target }) => {
    const looksOurs = exists(join('runtime', name.split('/')[0])) && name.includes('/');
    return quote === '"' ? !target : target && looksOurs;
  });
  assert.deepEqual(wrong.map(where), []);
});

test('OpenCV comes by its module headers, never by the umbrella', () => {
  const umbrella = everyInclude.filter(({ name }) => /^opencv2\/opencv\.hpp$|^opencv2\/opencv_modules/.test(name));
  assert.deepEqual(umbrella.map(where), []);
});

test('headers take only json_fwd.hpp, sources the whole of nlohmann', () => {
  const heavy = everyInclude.filter(({ path, name }) => path.endsWith('.h') && name === 'nlohmann/json.hpp');
  assert.deepEqual(heavy.map(where), []);
});

test('every room with sources has tests', () => {
  const rooms = new Set(sources.filter((p) => p.endsWith('.cpp')).map((p) => p.match(/^runtime\/(\w+)\//)?.[1]));
  rooms.delete(undefined);
  const untested = [...rooms].filter((room) => !files.some((p) => p.startsWith(`tests/runtime/${room}/`)));
  assert.deepEqual(untested, []);
});
