// `mirada serve`: the program itself, from the build tree and installed.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { request } from 'node:http';
import { join } from 'node:path';
import { test } from 'node:test';
import { file, folder, freePort, mirada, refused, root, serve } from './support.mjs';

/** One request; node's fetch would not let us set Host. */
function ask(address, path, { method = 'GET', headers = {} } = {}) {
  return new Promise((resolve, reject) => {
    const sent = request(new URL(path, address), { method, headers }, (answer) => {
      let body = '';
      answer.setEncoding('utf8').on('data', (chunk) => (body += chunk));
      answer.on('end', () => resolve({ status: answer.statusCode, headers: answer.headers, body }));
    });
    sent.on('error', reject).end();
  });
}

test('it serves the editor, its packs, rooms and examples, and ends when it is told to', async () => {
  const robot = await serve(['--port', String(await freePort())]);
  const page = await ask(robot.address, '/');
  assert.equal(page.status, 200);
  assert.match(page.headers['content-type'], /text\/html/);
  const packs = JSON.parse((await ask(robot.address, '/api/packs')).body).packs.map((pack) => pack.id);
  for (const id of ['events', 'control', 'motion', 'vision']) assert.ok(packs.includes(id), id);
  assert.ok(JSON.parse((await ask(robot.address, '/api/setup')).body).worlds.length >= 3);
  assert.ok(JSON.parse((await ask(robot.address, '/api/examples')).body).examples.length >= 1);
  assert.equal((await ask(robot.address, '/', { headers: { Host: 'elsewhere.example' } })).status, 421);
  const crossed = { method: 'POST', headers: { Origin: 'http://elsewhere.example' } };
  assert.equal((await ask(robot.address, '/api/check', crossed)).status, 403);
  assert.equal((await ask(robot.address, '/api/stop', { method: 'POST' })).status, 204);
  assert.deepEqual(await robot.stop(), { code: 0, signal: null });
});

test('a busy port, an unknown room or robot, a missing camera: one clear sentence each', async () => {
  const port = String(await freePort());
  const robot = await serve(['--port', port]);
  refused(mirada(['serve', '--port', port]), new RegExp(port));
  await robot.stop('SIGINT');
  refused(mirada(['serve', '--port', port, '--world', 'moon']), /moon/);
  refused(mirada(['serve', '--port', port, '--robot', 'nobody']), /nobody/);
  refused(mirada(['serve', '--port', port, '--camera', 'v4l2:77']), /77/);
});

test('its own broken file of known faces keeps no robot from starting, and stays; one that was named is refused', async () => {
  mkdirSync(join(folder, 'own/mirada/faces'), { recursive: true });
  const known = file('own/mirada/faces/known.json', '{');
  const robot = await serve(['--port', String(await freePort())], { env: { ...process.env, XDG_DATA_HOME: join(folder, 'own') } });
  await robot.stop();
  assert.match(robot.said(), /known\.json can't be read[^]*not whole JSON[^]*Until then I know nobody/);
  assert.equal(readFileSync(known, 'utf8'), '{');
  refused(mirada(['serve', '--port', String(await freePort()), '--known-faces', known]), /known\.json can't be read/);
});

test('installed it finds its data beside itself', async () => {
  const prefix = join(folder, 'installed');
  const install = spawnSync('cmake', ['--install', join(root, 'build/release'), '--prefix', prefix], { encoding: 'utf8' });
  assert.equal(install.status, 0, install.stderr);
  const binary = join(prefix, 'bin/mirada');
  const robot = await serve(['--port', String(await freePort())], { binary });
  assert.equal((await ask(robot.address, '/')).status, 200);
  assert.ok(JSON.parse((await ask(robot.address, '/api/packs')).body).packs.length > 5);
  await robot.stop();
  const example = join(prefix, 'share/mirada/blocks/vision/examples/avoid.json');
  assert.equal(mirada(['run', example, '--seconds', '1'], { binary, cwd: '/' }).status, 0);
});
