// `mirada see`: pictures and videos from files.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { file, fits, folder, mirada, readJson, refused, shipped } from './support.mjs';

const photographs = '/usr/share/doc/opencv-doc/examples/data';
const photograph = join(photographs, 'left01.jpg');
const answers = ['blocked', 'clear', 'not_seen', 'above_horizon'];

test('a photograph gives an answer for every degree that the camera sees', () => {
  const overlay = join(folder, 'overlay.png');
  const answer = mirada(['see', photograph, '--robot', 'mirada-sim', '--pan', '20', '--json', '--overlay', overlay]);
  assert.equal(answer.status, 0, answer.err);
  const report = JSON.parse(answer.out);
  fits(report, 'see');
  const bearings = report.sonar.map((reading) => reading.bearing_deg);
  assert.ok(bearings.length > 50 && bearings.includes(20));
  for (const { answer: kind, distance_m: distance } of report.sonar) {
    assert.ok(answers.includes(kind));
    assert.equal(distance === null, kind === 'not_seen' || kind === 'above_horizon');
  }
  assert.ok(Array.isArray(report.faces));
  assert.ok(existsSync(overlay));
});

test('a video gives a report for every picture', () => {
  const answer = mirada(['see', join(photographs, 'Megamind.avi'), '--robot', 'mirada-sim', '--json', '--no-faces']);
  if (answer.status === 2) return refused(answer, /Megamind\.avi is \d+ x \d+/);
  const lines = answer.out.trim().split('\n').map((line) => JSON.parse(line));
  assert.ok(lines.length > 10 && lines.every((line) => line.sonar.length > 0));
});

test('what is no picture, what is missing and a robot with faults are said at once', () => {
  const robot = readJson(shipped('runtime/model/robots/pibot.json'));
  robot.mount.height_m = -1;
  robot.camera.hfov_deg = 400;
  const bad = file('robot.json', robot);
  refused(
    mirada(['see', file('text.png', 'no picture'), 'nowhere.jpg', '--robot', bad, '--json']),
    /text\.png/,
    /nowhere\.jpg/,
    /height_m/,
    /hfov_deg/,
  );
});

const model = shipped('build/models/faces.onnx');
const players = join(photographs, 'basketball1.png');

test('faces come with their box in source pixels', { skip: !existsSync(model) && 'the model was not fetched' }, () => {
  const answer = mirada(['see', players, '--robot', 'mirada-sim', '--json']);
  assert.equal(answer.status, 0, answer.err);
  const report = JSON.parse(answer.out);
  fits(report, 'see');
  const there = report.faces.find(({ x, y, w, h }) => x < 88 && x + w > 88 && y < 113 && y + h > 113);
  assert.ok(there && there.w > 25 && there.w < 60 && there.h > 30 && there.h < 70, JSON.stringify(report.faces));
  assert.equal(there.detector, 'ultraface');
  const own = mirada(['see', players, '--robot', 'mirada-sim', '--json', '--model', model]);
  assert.deepEqual(JSON.parse(own.out).faces, report.faces);
});

test('a model that is none is said so', () => {
  const see = (path) => mirada(['see', players, '--robot', 'mirada-sim', '--json', '--model', path]);
  refused(see(file('model.onnx', 'no network')), /model\.onnx is no face model/);
  refused(see('/nowhere/model.onnx'), /can't find the face model/);
});
