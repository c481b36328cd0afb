// `mirada faces`: who is known, at a terminal; and `mirada see`, which says their names.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { file, folder, mirada, refused, shipped } from './support.mjs';

const photographs = '/usr/share/doc/opencv-doc/examples/data';
const known = join(folder, 'known.json');
const faces = (...args) => mirada(['faces', '--file', known, ...args]);
const fetched = existsSync(shipped('build/models/faces.onnx')) && existsSync(shipped('build/models/face-feature.onnx'));

test('somebody is learnt from a picture and known in another, renamed and forgotten', { skip: !fetched && 'the models were not fetched' }, () => {
  const learnt = faces('learn', 'Ana', join(photographs, 'basketball1.png'));
  assert.equal(learnt.status, 0, learnt.err);
  assert.equal(faces('rename', 'Ana', 'Eva').status, 0);
  assert.match(faces('list').out, /is off[^]*Eva: 1 looks/);
  const seen = mirada(['see', join(photographs, 'basketball2.png'), '--json', '--known-faces', known]);
  const [face] = JSON.parse(seen.out).faces;
  assert.deepEqual([face.name, face.who], ['Eva', 'known']);
  assert.equal(faces('forget', 'Eva').status, 0);
  assert.doesNotMatch(readFileSync(known, 'utf8'), /Eva|feature/);
});

test('the switch is kept, and what is wrong is said', () => {
  assert.equal(faces('allow', 'on').status, 0);
  assert.match(faces('list').out, /allowed/);
  refused(faces('forget', 'nobody'), /I know nobody called nobody/);
  refused(faces('learn', 'Ana', join(photographs, 'left01.jpg')), /no face/);
  refused(mirada(['faces', 'learn', 'Ana', file('text.png', 'text'), '--file', known]), /text\.png is no picture/);
  refused(mirada(['faces', '--file', file('broken.json', '{'), 'list']), /broken\.json can't be read/);
});
