// The editor in a real browser, against a robot that can be made to vanish, refuse or stay silent.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach, before, beforeEach, describe, test } from 'node:test';
import { blockBox, drag, launch, on, openPage } from './support/browser.mjs';
import { FakeRobot, origin } from './support/fake_robot.mjs';
import { chainOf, longProgram } from './support/long_program.mjs';

const folder = mkdtempSync(join(tmpdir(), 'mirada-e2e-'));
const blockText = async (page, id) =>
  (await page.locator(on.block(id)).first().textContent()).replace(/\u00a0/g, ' ');

async function start(page) {
  await page.goto(origin);
  await page.locator(on.block('hat')).first().waitFor();
  await page.locator(`${on.flag}:not([disabled])`).waitFor();
}

async function openText(page, name, text) {
  const file = join(folder, name);
  writeFileSync(file, text);
  await page.setInputFiles('input[type=file]', file);
}

async function download(page) {
  await page.locator('.project-name').click();
  const [event] = await Promise.all([
    page.waitForEvent('download'),
    page.getByText('Download as a file').click(),
  ]);
  return JSON.parse(readFileSync(await event.path(), 'utf8'));
}

function program(...blocks) {
  const workspace = { blocks: { languageVersion: 0, blocks }, variables: [] };
  return JSON.stringify({ format: 'mirada-program', version: 1, name: 'From a file', packs: [], workspace });
}

function stackOf(list) {
  for (let i = list.length - 1; i > 0; i--) list[i - 1].next = { block: list[i] };
  return { type: list[0].type, id: list[0].id, x: 20, y: 20, ...list[0] };
}

const wait = (id, seconds = 1) => ({
  type: 'control_wait',
  id,
  inputs: { DURATION: { shadow: { type: 'math_number', id: `${id}s`, fields: { NUM: seconds } } } },
});

describe('the editor', { timeout: 900_000 }, () => {
  let browser;
  let page;
  let robot;

  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());
  beforeEach(async () => {
    page = await openPage(browser);
    robot = await FakeRobot.serve(page);
  });
  afterEach(async () => {
    robot.dispose();
    await page.context().close();
  });

  test('a first visit opens Avoid the obstacles, saves it, and the browser has nothing to complain about', async () => {
    await start(page);
    assert.equal(await page.locator('[data-testid=project-name]').textContent(), 'Avoid the obstacles ▾');
    await page.locator(on.saved).waitFor();
    assert.deepEqual(page.problems, []);
  });

  test('the program that the flag sends is the one on the canvas', async () => {
    await start(page);
    await page.click(on.flag);
    await page.locator('.mirada-running').first().waitFor();
    const sent = robot.received.find((message) => message.type === 'run').program;
    assert.equal(sent.format, 'mirada-program');
    assert.deepEqual(sent.packs, ['events', 'control', 'motion', 'vision']);
    assert.equal(sent.workspace.blocks.blocks[0].id, 'hat');
  });

  test('Stop answers at once and says so until the robot confirms', async () => {
    await start(page);
    await page.click(on.flag);
    await page.locator('.mirada-running').first().waitFor();
    robot.stopAnswers = false;
    await page.click(on.stop);
    assert.match(await page.locator(on.stop).textContent(), /Stopping…/);
    await page.waitForTimeout(300);
    assert.match(await page.locator(on.stop).textContent(), /Stopping…/);
    assert.ok(robot.received.some((message) => message.type === 'stop'));
    robot.stopAnswers = true;
    robot.halt('stop_button');
    await page.locator(on.stop, { hasText: /^Stop$/ }).waitFor();
    await page.locator('.mirada-running').first().waitFor({ state: 'detached' });
    assert.equal(await page.locator(on.status).textContent(), 'Stopped.');
  });

  test('Stop stops while a dialog is open', async () => {
    await start(page);
    await page.click(on.flag);
    await page.locator('.mirada-running').first().waitFor();
    await page.getByRole('button', { name: 'Robot and room' }).click();
    await page.locator('dialog[open]').waitFor();
    const box = await page.locator(on.stop).boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await page.locator('.mirada-running').first().waitFor({ state: 'detached' });
    assert.ok(robot.received.some((message) => message.type === 'stop'));
  });

  test('Escape stops, and keys reach the program only while it runs and nobody edits', async () => {
    await start(page);
    await page.keyboard.press('ArrowUp');
    await page.click(on.flag);
    await page.locator('.mirada-running').first().waitFor();
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Space');
    await page.focus('.search input');
    await page.keyboard.press('a');
    const keys = robot.received.filter((message) => message.type === 'key');
    assert.deepEqual(keys, [
      { type: 'key', key: 'up arrow', down: true },
      { type: 'key', key: 'up arrow', down: false },
      { type: 'key', key: 'space', down: true },
      { type: 'key', key: 'space', down: false },
    ]);
    await page.keyboard.press('Escape');
    await page.locator('.mirada-running').first().waitFor({ state: 'detached' });
    assert.ok(robot.received.some((message) => message.type === 'stop'));
  });

  test('the language changes blocks, toolbox and words; the program and its undo stay', async () => {
    await start(page);
    await page.keyboard.press('Control+a');
    const before = await download(page);
    await page.click('[data-testid=lang]');
    await page.getByText('Español').click();
    await page.locator(on.category('Movimiento')).waitFor();
    assert.match(await blockText(page, 'hat'), /al pulsar la bandera/);
    assert.match(await page.locator(on.stop).textContent(), /Parar/);
    assert.equal(await page.evaluate(() => document.documentElement.lang), 'es');
    await page.click('[data-testid=lang]');
    await page.getByText('English').click();
    await page.locator(on.category('Motion')).waitFor();
    assert.deepEqual(await download(page), before);
    assert.deepEqual(page.problems, []);
  });

  test('the blocks that run stay lit when the language changes', async () => {
    await start(page);
    await page.click(on.flag);
    await page.locator('.mirada-running').first().waitFor();
    const lit = await page.locator('.mirada-running').count();
    await page.click('[data-testid=lang]');
    await page.getByText('Español').click();
    await page.locator(on.category('Movimiento')).waitFor();
    assert.equal(await page.locator('.mirada-running').count(), lit);
  });

  test('a decimal comma is kept, and a number that cannot be kept changes nothing', async () => {
    await start(page);
    await openText(
      page,
      'wait.json',
      program(stackOf([{ type: 'event_whenflagclicked', id: 'hat' }, wait('a')])),
    );
    await page.locator(on.block('a')).first().waitFor();
    const type = async (text) => {
      await page
        .locator(`${on.block('as')} text`)
        .first()
        .click();
      await page.keyboard.press('Control+a');
      await page.keyboard.type(text);
      await page.keyboard.press('Enter');
      const stack = (await download(page)).workspace.blocks.blocks[0];
      return stack.next.block.inputs.DURATION.shadow.fields.NUM;
    };
    assert.equal(await type('0,5'), 0.5);
    assert.equal(await type('1e400'), 0.5);
    assert.equal(await type('9'.repeat(320)), 0.5);
    assert.deepEqual(page.problems, []);
  });

  test('blocks that nothing begins are answered with what to do, and are not sent', async () => {
    await start(page);
    await openText(page, 'nohat.json', program(stackOf([wait('a')])));
    await page.locator(on.block('a')).first().waitFor();
    await page.click(on.flag);
    await page.locator(on.status, { hasText: /put .when flag pressed. on top/ }).waitFor();
    assert.ok(!robot.received.some((message) => message.type === 'run'));
  });

  test('a run that is over before the answer says how it ended', async () => {
    await start(page);
    robot.endsAtOnce = 'faulted';
    await page.click(on.flag);
    await page.locator(on.status, { hasText: 'The program cannot go on' }).waitFor();
    await page.waitForTimeout(300);
    assert.match(await page.locator(on.status).textContent(), /The program cannot go on/);
  });

  test('a reload keeps the work', async () => {
    await start(page);
    const box = await blockBox(page, 'hat');
    await drag(page, { x: box.x + 20, y: box.y + 40 }, { x: box.x + 120, y: box.y + 140 });
    await page.locator(on.saved).waitFor();
    const before = await download(page);
    assert.notEqual(before.workspace.blocks.blocks[0].x, 40);
    await page.reload();
    await page.locator(on.block('hat')).first().waitFor();
    assert.deepEqual(await download(page), before);
  });

  test('work that was not saved yet when the page went away is recovered', async () => {
    await start(page);
    await page.locator(on.saved).waitFor();
    const box = await blockBox(page, 'hat');
    await drag(page, { x: box.x + 20, y: box.y + 40 }, { x: box.x + 200, y: box.y + 100 });
    await page.reload();
    await page.locator(on.block('hat')).first().waitFor();
    assert.notEqual((await download(page)).workspace.blocks.blocks[0].x, 40);
  });

  test('two tabs on one project keep both works', async () => {
    await start(page);
    await page.locator(on.saved).waitFor();
    const other = await page.context().newPage();
    const second = await FakeRobot.serve(other);
    await start(other);
    const moves = async (where, by) => {
      const box = await blockBox(where, 'hat');
      await drag(where, { x: box.x + 20, y: box.y + 40 }, { x: box.x + 20 + by, y: box.y + 90 });
      await where.locator(on.saved).waitFor();
    };
    await moves(page, 60);
    await moves(other, 180);
    await other.locator('[data-testid=project-name]', { hasText: '(copy)' }).waitFor();
    assert.match(await other.locator(on.status).textContent(), /another tab/);
    await other.locator('.project-name').click();
    await other.getByRole('menuitem', { name: 'Avoid the obstacles', exact: true }).waitFor();
    second.dispose();
  });

  test('unknown blocks are grey, stay where they are and are saved unchanged', async () => {
    await start(page);
    const unknown = {
      type: 'arm_grab',
      id: 'grab',
      extraState: { hand: ['left', { deep: null }] },
      fields: { SPEED: 3, MODE: 'soft' },
      inputs: {
        FORCE: { shadow: { type: 'math_number', id: 'f', fields: { NUM: 7 } } },
        DO: { block: wait('inside') },
      },
    };
    const text = program(
      stackOf([{ type: 'event_whenflagclicked', id: 'hat' }, wait('a'), unknown, wait('z')]),
    );
    await openText(page, 'unknown.json', text);
    await page.locator(on.block('z')).first().waitFor();
    assert.match(await blockText(page, 'grab'), /arm_grab/);
    assert.match(await page.locator(on.status).textContent(), /not known here|is open/);
    const saved = await download(page);
    assert.equal(JSON.stringify(saved.workspace.blocks), JSON.stringify(JSON.parse(text).workspace.blocks));
    assert.deepEqual(page.problems, []);
  });

  test('a bad file is one clear sentence, and nothing is lost', async () => {
    await start(page);
    const before = await download(page);
    await openText(page, 'bad.json', '{"format": "mirada-pro');
    const dialog = page.getByRole('dialog');
    await dialog.waitFor();
    assert.match(await dialog.textContent(), /cannot be read. Nothing was changed/);
    await page.keyboard.press('Enter');
    await dialog.waitFor({ state: 'detached' });
    assert.deepEqual(await download(page), before);
  });

  test('5,000 blocks in one stack open, are saved, come back and travel', async () => {
    await start(page);
    await openText(page, 'long.json', longProgram(5000));
    await page.locator(on.block('w4999')).first().waitFor({ state: 'attached', timeout: 90_000 });
    const wanted = [
      'event_whenflagclicked hat',
      ...Array.from({ length: 4999 }, (_, i) => `control_wait w${i + 1} ${(i + 1) % 10}`),
    ];
    assert.deepEqual(chainOf(await download(page)), wanted);
    await page.locator(on.saved).waitFor({ timeout: 60_000 });
    await page.reload();
    await page.locator(on.block('w4999')).first().waitFor({ state: 'attached', timeout: 90_000 });
    await page.locator(`${on.flag}:not([disabled])`).waitFor();
    await page.click(on.flag);
    await page.locator('[data-testid=flag].on').waitFor({ timeout: 60_000 });
    assert.deepEqual(chainOf(robot.program), wanted);
    assert.deepEqual(page.problems, []);
  });

  test('faults stand on their block in words, and in the log', async () => {
    await start(page);
    const message = { en: 'This speed is no number.', es: 'Esta velocidad no es un número.' };
    robot.refuse = [{ place: 'speeds', code: 'bad_number', severity: 'error', message }];
    await page.click(on.flag);
    await page
      .locator(`${on.block('speeds')}.mirada-fault`)
      .first()
      .waitFor();
    await page.locator('.blocklyBubble', { hasText: 'This speed is no number.' }).first().waitFor();
    assert.match(await page.locator(on.status).textContent(), /One block needs your help/);
    await page.getByRole('tab', { name: /Log/ }).click();
    assert.match(await page.locator('.log').textContent(), /This speed is no number/);
    robot.refuse = null;
    await page.click(on.flag);
    await page.locator('.mirada-fault').first().waitFor({ state: 'detached' });
  });

  test('a lost connection is said, and mends itself; the program stays', async () => {
    await start(page);
    await robot.vanish();
    await page.locator(on.banner).waitFor();
    assert.match(await page.locator(on.banner).textContent(), /Your program is safe/);
    await page.getByRole('button', { name: 'Robot and room' }).click();
    await page.getByLabel('Living room').check();
    await page.getByRole('button', { name: 'Use it' }).click();
    await page.locator(on.status, { hasText: 'The robot does not answer now' }).waitFor();
    await page.keyboard.press('Escape');
    const box = await blockBox(page, 'hat');
    await drag(page, { x: box.x + 20, y: box.y + 40 }, { x: box.x + 120, y: box.y + 140 });
    await page.locator(on.saved).waitFor();
    robot.reachable = true;
    await page.locator(on.banner).waitFor({ state: 'detached', timeout: 15_000 });
    await page.locator(`${on.flag}:not([disabled])`).waitFor();
    await page.locator(on.block('hat')).first().waitFor();
  });

  test('somebody else drives: the flag rests, Stop does not', async () => {
    robot.owner = 'viewer-9';
    robot.state = 'running';
    await page.goto(origin);
    await page.locator('[data-testid=driver]', { hasText: 'Somebody else drives' }).waitFor();
    assert.ok(await page.locator(on.flag).isDisabled());
    await page.click(on.stop);
    await page.waitForTimeout(200);
    assert.equal(robot.state, 'idle');
  });

  test('a clicked reporter shows its value', async () => {
    await start(page);
    const box = await blockBox(page, 'clear');
    await page.mouse.click(box.x + 12, box.y + box.height / 2);
    await page.locator('.value-bubble', { hasText: '42.5' }).waitFor();
    const asked = robot.received.find((message) => message.type === 'evaluate');
    assert.equal(asked.block, 'clear');
  });

  test('a variable is made in our own dialog and shown while it runs', async () => {
    await start(page);
    await page.click(on.category('Variables'));
    await page.locator('.blocklyFlyoutButton', { hasText: 'Make a variable' }).click();
    await page.keyboard.type('speed');
    await page.keyboard.press('Enter');
    await page.locator('.blocklyFlyout .data_setvariableto').waitFor();
    robot.extra = {
      variables: { speed: 12.345 },
      lists: { path: [1, 'two'] },
      list_lengths: { path: 5000 },
    };
    await page.locator('[data-variable=speed] output', { hasText: '12.35' }).waitFor();
    await page.locator('[data-list=path] li', { hasText: 'two' }).waitFor();
    assert.match(await page.locator('[data-list=path]').textContent(), /length 5000/);
    const set = await page.locator('.blocklyFlyout .data_setvariableto').boundingBox();
    await drag(page, { x: set.x + 8, y: set.y + 8 }, { x: 700, y: 500 });
    await page
      .locator('.blocklySvg .blocklyBlockCanvas .data_setvariableto .blocklyDropdownText')
      .first()
      .click();
    await page.locator('.blocklyMenuItem', { hasText: 'Delete “speed”' }).waitFor();
  });

  test('undo takes back a drag', async () => {
    await start(page);
    const box = await blockBox(page, 'hat');
    await drag(page, { x: box.x + 20, y: box.y + 40 }, { x: box.x + 120, y: box.y + 140 });
    const moved = await blockBox(page, 'hat');
    assert.ok(Math.abs(moved.x - box.x) > 50);
    await page.getByRole('button', { name: 'Redo' }).and(page.locator(':disabled')).waitFor();
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.waitForTimeout(200);
    const back = await blockBox(page, 'hat');
    assert.ok(Math.abs(back.x - box.x) < 2);
  });

  test('a camera that fell silent is said in a sentence, and its old picture pales', async () => {
    await start(page);
    for (const code of ['camera_lost', 'camera_missing', 'some_new_code']) {
      robot.extra = { camera_trouble: code };
      await page.locator('.picture-frame.stale .over-picture', { hasText: /camera.*\./ }).waitFor();
      assert.doesNotMatch(await page.locator('.over-picture').textContent(), /_/);
    }
    robot.extra = {};
    await page.locator('.picture-frame:not(.stale)').waitFor();
  });

  test('room, robot and seed are chosen in one dialog; the picture of the robot follows', async () => {
    await start(page);
    await page.getByRole('button', { name: 'Robot and room' }).click();
    await page.locator('.choice', { hasText: 'Living room' }).click();
    await page.getByRole('button', { name: 'Use it' }).click();
    await page.locator('.robot-button', { hasText: 'Living room' }).waitFor();
    const chosen = robot.received.find((message) => message.type === 'choose');
    assert.equal(chosen.world, 'living');
  });

  test('the side of the robot folds away, and the robot stops working for it', async () => {
    await start(page);
    await page.click('[data-testid=fold]');
    await page.waitForTimeout(200);
    const last = robot.received.filter((message) => message.type === 'watch').at(-1);
    assert.deepEqual(last, {
      type: 'watch',
      camera: false,
      sonar: false,
      faces: false,
      room: false,
      memory: false,
    });
    await page.reload();
    await page.locator('.page.folded').waitFor();
  });
});
