// Runs the release program as somebody at a terminal does.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { faults } from '../architecture/json_schema.mjs';

export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
export const program = join(root, 'build/release/bin/mirada');
export const folder = mkdtempSync(join(tmpdir(), 'mirada-commands-'));
after(() => rmSync(folder, { recursive: true, force: true }));

/** {status, out, err} of one command; a command that hangs is killed after two minutes and has no status. */
export function mirada(args, { binary = program, ...options } = {}) {
  const run = spawnSync(binary, args, { encoding: 'utf8', timeout: 120_000, maxBuffer: 1 << 28, ...options });
  return { status: run.status, out: run.stdout, err: run.stderr };
}

export function file(name, content) {
  const path = join(folder, name);
  writeFileSync(path, typeof content === 'object' && !Buffer.isBuffer(content) ? JSON.stringify(content) : content);
  return path;
}

export const shipped = (path) => join(root, path);
export const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));

/** The value fits docs/schema/NAME.schema.json. */
export function fits(value, name) {
  assert.deepEqual(faults(value, readJson(shipped(`docs/schema/${name}.schema.json`))), []);
}

/** Bad input is answered in words with status 2: never a crash, never silence, never a raw exception. */
export function refused(answer, ...words) {
  const text = answer.out + answer.err;
  assert.equal(answer.status, 2, text);
  assert.doesNotMatch(text, /terminate called|what\(\)|Segmentation|Assertion|std::/);
  for (const word of words) assert.match(text, word instanceof RegExp ? word : new RegExp(word));
}

/** The text of a stack, however long: JSON.stringify would overflow on some thousand nested `next`. */
function stackText(blocks) {
  const opened = blocks.map((block) => JSON.stringify(block).slice(0, -1)).join(',"next":{"block":');
  return `${opened}}${'}}'.repeat(blocks.length - 1)}`;
}

/** A program's text with one script: these blocks under a flag hat. */
export function flagProgram(...blocks) {
  const script = stackText([{ type: 'event_whenflagclicked', id: 'hat', x: 0, y: 0 }, ...blocks]);
  const variables = JSON.stringify([{ name: 'n', id: 'vn', type: '' }]);
  const workspace = `{"blocks": {"languageVersion": 0, "blocks": [${script}]}, "variables": ${variables}}`;
  return `{"format": "mirada-program", "version": 1, "name": "test", "packs": ["events", "data"], "workspace": ${workspace}}`;
}

const number = (value) => ({ shadow: { type: 'math_number', id: `s${Math.random()}`, fields: { NUM: value } } });
export const changeN = (id, by = 1) => ({
  type: 'data_changevariableby',
  id,
  fields: { VARIABLE: { id: 'vn' } },
  inputs: { VALUE: number(by) },
});

export async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await new Promise((resolve) => server.once('listening', resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

/** Starts `mirada serve`; resolves when it says that it is ready, with its address, and stop() that waits for its end. */
export function serve(args, { binary = program, env = process.env } = {}) {
  const child = spawn(binary, ['serve', ...args], { env, stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.once('exit', (code, signal) => resolve({ code, signal })));
  const stop = (signal = 'SIGTERM') => {
    child.kill(signal);
    return ended;
  };
  return new Promise((resolve, reject) => {
    let said = '';
    const listen = (chunk) => {
      said += chunk;
      const address = said.match(/http:\/\/[\w.[\]:]+\//)?.[0];
      if (address) resolve({ address, stop, ended, said: () => said });
    };
    child.stdout.on('data', listen);
    child.stderr.on('data', listen);
    ended.then(({ code }) => reject(new Error(`ended with ${code}: ${said}`)));
  });
}
