// `mirada run` and `mirada check`: what runs without a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { archive, catProject } from '../e2e/support/scratch_file.mjs';
import { changeN, file, fits, flagProgram, mirada, readJson, refused, shipped } from './support.mjs';

const avoid = shipped('blocks/vision/examples/avoid.json');

function report(args) {
  const answer = mirada(['run', ...args, '--report', '-']);
  assert.equal(answer.status, 0, answer.err);
  const run = JSON.parse(answer.out);
  fits(run, 'run-report');
  return run;
}

for (const world of ['sala-1', 'green-field', 'workshop']) {
  test(`the first program drives round ${world} and touches nothing`, () => {
    const run = report([avoid, '--world', world, '--seed', '11', '--seconds', '40']);
    assert.equal(run.status, 'time_up');
    assert.deepEqual(run.faults, []);
    assert.equal(run.robot.contacts, 0);
    assert.ok(run.robot.path_m > 1.5, `only ${run.robot.path_m} m`);
    assert.match(run.hash, /^[0-9a-f]{64}$/);
  });
}

test('the same seed gives the same run, another seed another', () => {
  const [first, again, other] = ['5', '5', '6'].map((seed) => report([avoid, '--seed', seed, '--seconds', '5']));
  assert.deepEqual({ ...first, wall_s: 0 }, { ...again, wall_s: 0 });
  assert.notEqual(first.hash, other.hash);
});

test('5,000 blocks in one stack run', () => {
  const blocks = Array.from({ length: 4999 }, (_, i) => changeN(`b${i}`));
  const run = report([file('long.json', flagProgram(...blocks)), '--world', 'none']);
  assert.equal(run.status, 'finished');
  assert.equal(run.variables.n, 4999);
});

test('a Scratch project runs from its archive and from its bare JSON, without what needs a stage', () => {
  const bare = catProject('pen_penDown');
  const files = [file('cat.sb3', archive({ 'a.svg': '<svg/>', 'project.json': bare })), file('project.json', bare)];
  for (const path of files) {
    const run = report([path, '--world', 'none']);
    assert.equal(run.status, 'finished');
    assert.deepEqual(run.variables, { 'Cat.lives': '9' });
    assert.deepEqual(run.say.map(({ text }) => text), ['9']);
    assert.deepEqual(run.faults.map(({ code }) => code), ['stage_blocks']);
    assert.match(run.faults[0].message.en ?? run.faults[0].message, /pen_penDown/);
  }
});

test('what is no Scratch 3 project is refused in words', () => {
  refused(mirada(['run', file('old.sb3', archive({ 'project.json': '{"objName":"Stage"}' }))]), /Scratch 2/);
  refused(mirada(['run', file('cut.sb3', archive({ 'project.json': '{"targets":[' }))]), /byte/);
  refused(mirada(['run', file('none.sb3', archive({ 'readme.txt': '' }))]), /project\.json/);
  refused(mirada(['run', file('bomb.sb3', archive({ 'project.json': '[' + ' '.repeat(20 << 20) }))]), /16 MiB/);
});

test('5,001 blocks, cut-off JSON, an unknown block, no file: each is refused in words', () => {
  const blocks = Array.from({ length: 5000 }, (_, i) => changeN(`b${i}`));
  const whole = flagProgram(changeN('b'));
  const bad = {
    'too-many.json': [flagProgram(...blocks), /5,?000/],
    'cut.json': [whole.slice(0, 200), /byte/],
    'unknown.json': [flagProgram({ type: 'magic_fly', id: 'm1' }, { type: 'magic_land', id: 'm2' }), /m1[^]*m2/],
    'empty.json': ['', /./],
    'list.json': ['[1, 2]', /./],
  };
  for (const [name, [content, words]] of Object.entries(bad)) {
    const path = file(name, content);
    refused(mirada(['check', path]), words);
    refused(mirada(['run', path, '--world', 'none']), words);
  }
  refused(mirada(['run', 'nowhere.json']), /nowhere\.json/);
  refused(mirada(['check', '/']), /folder|file/);
});

test('what is wrong with program, room and robot is said in one answer', () => {
  const robot = readJson(shipped('runtime/model/robots/pibot.json'));
  robot.camera = { width_px: 320, height_px: 240, fx_px: -265, fy_px: 265 };
  robot.drive.track_m = -1;
  const path = file('robot.json', robot);
  refused(mirada(['run', 'nowhere.json', '--world', 'moon', '--robot', path]), /nowhere/, /moon/, /fx_px/, /track_m/);
});

test('an invalid run still writes its report', () => {
  const answer = mirada(['run', 'nowhere.json', '--report', '-']);
  assert.equal(answer.status, 2);
  const run = JSON.parse(answer.out);
  fits(run, 'run-report');
  assert.equal(run.status, 'invalid');
  assert.ok(run.faults.length > 0 && run.faults.every((fault) => fault.message.length > 0));
});

test('check finds nothing wrong with what ships', () => {
  assert.equal(mirada(['check', avoid]).status, 0);
});

test('what the command line does not know is refused', () => {
  refused(mirada([]), /subcommand/);
  refused(mirada(['run', avoid, '--speed', '9']), /--speed/);
  refused(mirada(['run', avoid, '--seconds', '-1']), /--seconds/);
});

test('every subcommand explains itself', () => {
  const { out } = mirada(['--help']);
  const names = [...out.matchAll(/^ {2}(\w+) {2,}/gm)].map((match) => match[1]).filter((name) => name !== 'h');
  assert.ok(['serve', 'run', 'check', 'see'].every((name) => names.includes(name)), out);
  for (const name of names) assert.equal(mirada([name, '--help']).status, 0, name);
});

test('what is meant for a subcommand and is none is named, with those that there are', () => {
  refused(mirada(['drive']), /"drive".*run.*serve/s);
  refused(mirada(['--bogus']), /"--bogus"/);
});

test('a number that is none is refused', () => {
  refused(mirada(['run', avoid, '--seconds', 'nan']), /nan is not a number in/);
  refused(mirada(['run', avoid, '--seed', '-1']), /-1 is not a number in/);
  refused(mirada(['see', avoid, '--pan', 'nan']), /nan is not a number in/);
});

test('a program file that is broken is named', () => {
  const broken = file('broken.json', '{bad');
  refused(mirada(['run', broken]), /broken\.json: This is not whole JSON/);
  refused(mirada(['check', broken]), /broken\.json: This is not whole JSON/);
});
