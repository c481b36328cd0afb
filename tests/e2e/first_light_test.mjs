// From a block in the browser to a robot that sees and moves: the real program, the real browser, a simulated robot.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, describe, test } from 'node:test';
import { blockBox, drag, launch, on, openPage } from './support/browser.mjs';
import { longProgram } from './support/long_program.mjs';
import { archive, catProject } from './support/scratch_file.mjs';
import { RealRobot, listen, until } from './support/real_robot.mjs';

const still = ({ wheels }) => wheels.left_mps === 0 && wheels.right_mps === 0;
const place = ({ scene }) => [scene.robot.x_m, scene.robot.y_m];

/** The outline of the first block of this type in the open flyout. */
function flyoutBox(page, type) {
  return page.evaluate((wanted) => {
    const path = document.querySelector(`.blocklyFlyout .${wanted} > .blocklyPath`);
    const { x, y, width, height } = path.getBoundingClientRect();
    return { x, y, width, height };
  }, type);
}

/** Drags a block out of the toolbox so that its top left corner comes to a point. */
async function dragFromToolbox(page, category, type, corner) {
  await page.click(on.category(category));
  await page.locator(`.blocklyFlyout .${type}`).first().waitFor();
  await page.waitForTimeout(300);
  const box = await flyoutBox(page, type);
  const grip = { x: 14, y: box.height / 2 };
  await drag(page, { x: box.x + grip.x, y: box.y + grip.y }, { x: corner.x + grip.x, y: corner.y + grip.y });
  await page.waitForTimeout(300);
}

describe('first light', { timeout: 600_000 }, () => {
  let browser;
  let robot;
  let page;
  let heard;

  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());
  beforeEach(async () => {
    robot = await RealRobot.start();
    page = await openPage(browser);
    heard = listen(page);
    await page.goto(robot.url);
    await page.locator('.blocklySvg .event_whenflagclicked').first().waitFor({ timeout: 60_000 });
    await page.locator(`${on.flag}:not([disabled])`).waitFor({ timeout: 30_000 });
  });
  afterEach(async () => {
    await page.context().close();
    await robot.stop();
  });

  test('Avoid the obstacles drives by what it sees, and Stop stops it', async () => {
    assert.match(await page.locator('[data-testid=project-name]').textContent(), /Avoid the obstacles/);
    await until('pictures', () => heard.frames.size > 0);
    await until('the room', () => heard.telemetry?.scene);
    const from = place(heard.telemetry);
    await page.click(on.flag);
    await until('a running program', () => heard.telemetry.state === 'running');
    await page.locator('.mirada-running').first().waitFor();
    const seen = heard.frames.size;
    await until(
      '10 cm of motion',
      () => Math.hypot(...place(heard.telemetry).map((c, i) => c - from[i])) > 0.1,
      30,
    );
    await until('new pictures', () => heard.frames.size > seen + 3);
    await until('an answer of the eyes', () => heard.telemetry.sonar?.trusted);
    const drawn = await page.locator('[data-testid=room]').getAttribute('data-pose');
    await until('motion in the drawing', async () => {
      return (await page.locator('[data-testid=room]').getAttribute('data-pose')) !== drawn;
    });
    await page.click(on.stop);
    await until('wheels at zero', () => heard.telemetry.state === 'idle' && still(heard.telemetry), 5);
    await page.locator(on.stop, { hasText: /^Stop$/ }).waitFor();
    await page.locator('.mirada-running').first().waitFor({ state: 'detached' });
    assert.deepEqual(page.problems, []);
  });

  test('a block dragged out of the toolbox does its work after the next flag', async () => {
    const ids = await page.evaluate(() => {
      const loop = document.querySelector('.blocklySvg .control_forever');
      return { first: loop.querySelector(':scope > .blocklyBlock').dataset.id };
    });
    await dragFromToolbox(page, 'Say', 'looks_say', await blockBox(page, ids.first));
    const said = await page.evaluate(() => {
      const shadow = document.querySelector(
        '.blocklySvg .control_forever > .looks_say > .text > .blocklyPath',
      );
      const { x, y } = shadow.getBoundingClientRect();
      return { x, y };
    });
    await dragFromToolbox(page, 'Vision', 'vision_obstacle_distance', said);
    await page.locator('.blocklySvg .looks_say > .vision_obstacle_distance').waitFor();
    await page.click(on.flag);
    await until('a distance over the robot', () => Number(heard.telemetry.say) > 0, 30);
    const bubble = await page.locator('.say-bubble').textContent();
    assert.ok(Number(bubble) > 0, bubble);
    await page.locator(on.saved).waitFor();
    await page.click(on.stop);
    await until('rest', () => still(heard.telemetry), 5);
    await page.reload();
    await page.locator('.blocklySvg .looks_say > .vision_obstacle_distance').waitFor({ timeout: 30_000 });
    assert.deepEqual(page.problems, []);
  });

  test('the language changes blocks and words', async () => {
    await page.click('[data-testid=lang]');
    await page.getByText('Español').click();
    await page.locator(on.category('Movimiento')).waitFor();
    const hat = await page.locator('.blocklySvg .event_whenflagclicked').first().textContent();
    assert.match(hat.replace(/\u00a0/g, ' '), /al pulsar la bandera/);
    assert.match(await page.locator(on.stop).textContent(), /Parar/);
  });

  test('an unknown block under the flag is refused on its block, in words', async () => {
    const program = {
      format: 'mirada-program',
      version: 1,
      name: 'With an arm',
      packs: [],
      workspace: {
        blocks: {
          languageVersion: 0,
          blocks: [
            {
              type: 'event_whenflagclicked',
              id: 'hat',
              x: 20,
              y: 20,
              next: { block: { type: 'arm_grab', id: 'grab' } },
            },
          ],
        },
      },
    };
    const buffer = Buffer.from(JSON.stringify(program));
    await page.setInputFiles('input[type=file]', { name: 'arm.json', mimeType: 'application/json', buffer });
    await page.locator(on.block('grab')).first().waitFor();
    await page.click(on.flag);
    await page.locator(`${on.block('grab')}.mirada-fault`).waitFor();
    await page.locator('.blocklyBubble').first().waitFor();
    assert.equal(heard.telemetry?.state ?? 'idle', 'idle');
  });

  test('5,000 blocks in one stack travel to the robot and run', async () => {
    const buffer = Buffer.from(longProgram(5000));
    await page.setInputFiles('input[type=file]', { name: 'long.json', mimeType: 'application/json', buffer });
    await page.locator(on.block('w4999')).first().waitFor({ state: 'attached', timeout: 120_000 });
    await page.click(on.flag);
    await until('a running program', () => heard.telemetry?.state === 'running', 60);
    const answered = () => heard.messages.find(({ type }) => type === 'started' || type === 'refused');
    await until('an answer', answered);
    const answer = answered();
    assert.deepEqual({ type: answer.type, warnings: answer.warnings }, { type: 'started', warnings: [] });
    await page.click(on.stop);
    await until('rest', () => heard.telemetry.state === 'idle', 5);
  });

  test('a Scratch project opens, says what became grey, and runs without it', async () => {
    const open = async (name, content) => {
      const buffer = archive({ 'project.json': content, 'picture.svg': '<svg/>' });
      await page.setInputFiles('input[type=file]', { name, mimeType: 'application/x.scratch.sb3', buffer });
      const dialog = page.getByRole('dialog');
      await dialog.waitFor();
      const words = await dialog.textContent();
      await page.keyboard.press('Enter');
      await dialog.waitFor({ state: 'detached' });
      return words;
    };
    assert.match(
      await open('Pen cat.sb3', catProject('pen_penDown')),
      /Pen cat.*side by side.*grey.*pen_penDown/,
    );
    await page.locator(on.block('extra')).first().waitFor();
    assert.match(await open('broken.sb3', '{'), /cannot be opened/);
    assert.match(
      await open('Cat.sb3', catProject()),
      /^“Cat” is open\. The scripts of all sprites stand side by side\./,
    );
    await page.locator(on.block('loop')).first().waitFor();
    await page.click(on.flag);
    await until('a running program', () => heard.telemetry?.state === 'running');
    await page.click(on.stop);
    await until('rest', () => heard.telemetry.state === 'idle', 5);
  });

  test('a clicked reporter shows its value from the robot', async () => {
    const box = await page.evaluate(() => {
      const path = document.querySelector('.blocklySvg .vision_way_clear > .blocklyPath');
      const { x, y, height } = path.getBoundingClientRect();
      return { x: x + 16, y: y + height / 2 };
    });
    await page.mouse.click(box.x, box.y);
    await page.locator('.value-bubble:not(.fault)').waitFor();
    assert.match(await page.locator('.value-bubble').textContent(), /true|false/);
  });

  test('a robot that goes away is missed, and found again; it does not drive on by itself', async () => {
    await page.click(on.flag);
    await until('a running program', () => heard.telemetry?.state === 'running');
    await robot.stop();
    await page.locator(on.banner).waitFor();
    await robot.launch();
    await page.locator(on.banner).waitFor({ state: 'detached', timeout: 30_000 });
    await until('a robot at rest', () => heard.telemetry?.state === 'idle' && still(heard.telemetry));
    await page.locator('.blocklySvg .event_whenflagclicked').first().waitFor();
  });

  test('a second browser watches, and may stop', async () => {
    const other = await openPage(browser);
    await other.goto(robot.url);
    await other.locator(`${on.flag}:not([disabled])`).waitFor({ timeout: 60_000 });
    await page.click(on.flag);
    await until('a running program', () => heard.telemetry?.state === 'running');
    await other
      .locator('[data-testid=driver]', { hasText: 'Somebody else drives' })
      .waitFor({ timeout: 60_000 });
    assert.ok(await other.locator(on.flag).isDisabled());
    await other.click(on.stop);
    await until('rest', () => heard.telemetry.state === 'idle' && still(heard.telemetry), 5);
    await other.context().close();
  });

  test('another room can be chosen, and the robot put back', async () => {
    const before = JSON.stringify(heard.telemetry?.scene?.bounds ?? null);
    const setup = await (await fetch(`${robot.url}/api/setup`)).json();
    const another = setup.worlds.find((world) => world.id !== setup.setup.world);
    await page.getByRole('button', { name: 'Robot and room' }).click();
    await page.locator('.choice', { hasText: another.name.en }).click();
    await page.getByRole('button', { name: 'Use it' }).click();
    await page.locator('.robot-button', { hasText: another.name.en }).waitFor();
    await until('another room', () => JSON.stringify(heard.telemetry?.scene?.bounds ?? null) !== before);
  });
});
