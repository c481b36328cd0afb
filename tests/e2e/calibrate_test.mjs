// The calibration wizard on the real server: with the board that the simulated room holds, and with real photographs.
import assert from 'node:assert/strict';
import {
  copyFileSync,
  existsSync,
  mkdtempSync,
  mkdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { launch, on, openPage, root } from './support/browser.mjs';
import { RealRobot, listen, until } from './support/real_robot.mjs';

const photographs = '/usr/share/doc/opencv-doc/examples/data';
const folder = mkdtempSync(join(tmpdir(), 'mirada-calibrate-'));
// Calibrations are kept below this; the robot inherits it.
process.env.XDG_DATA_HOME = join(folder, 'data');
const kept = join(folder, 'data/mirada/cameras/mirada-sim.simulated.camera.json');

const id = (name) => `[data-testid=${name}]`;
const json = (file) => JSON.parse(readFileSync(file, 'utf8'));

async function openEditor(browser, robot, options = {}) {
  const page = await openPage(browser, options);
  const heard = listen(page);
  await page.goto(robot.url);
  await page.locator(`${on.flag}:not([disabled])`).waitFor({ timeout: 60_000 });
  return { page, heard };
}

async function openWizard(page) {
  await page.click('.robot-button');
  await page.click(id('calibrate-open'));
  await page.locator(id('cal-begin')).waitFor();
}

const phase = (heard) => heard.messages.filter((m) => m.type === 'calibration').at(-1)?.phase;

describe('the calibration wizard', { timeout: 600_000 }, () => {
  let browser;
  before(async () => {
    browser = await launch();
  });
  after(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });

  test('the room holds the board, the lens is measured, saved and used after a restart', async () => {
    const robot = await RealRobot.start();
    try {
      const { page, heard } = await openEditor(browser, robot);
      await openWizard(page);
      await page.selectOption(id('cal-camera'), 'pi-camera-v2');
      await page.click(id('cal-begin'));
      await until('a board in the picture', () =>
        heard.messages.some((m) => m.type === 'calibration' && m.corners.length === 54),
      );
      assert.match(await page.locator(id('cal-next')).textContent(), /\w/);
      await page.locator(id('cal-save')).waitFor({ timeout: 240_000 });
      assert.match(
        await page.locator(id('cal-words')).textContent(),
        /sees 6[12][.\d]* degrees from side to side/,
      );
      await page.click(id('cal-save'));
      await page.locator(id('cal-words'), { hasText: 'Saved in' }).waitFor({ timeout: 60_000 });
      const camera = json(kept);
      assert.ok(Math.abs(camera.hfov_deg - 62.2) < 0.6, `${camera.hfov_deg} degrees`);
      assert.ok(camera.calibration.rms_px < 0.3);
      await page.click(id('cal-close'));
      await until('the end of the wizard', () => phase(heard) === 'off');
      assert.deepEqual(page.problems, []);
      await page.context().close();
    } finally {
      await robot.stop();
    }
    const again = await RealRobot.start();
    await again.stop();
    assert.doesNotMatch(again.words, /calibration/);
    const before = json(kept);
    before.height_px = 100; // no longer this robot's picture: it must say so and go on without it
    writeFileSync(kept, JSON.stringify(before));
    const odd = await RealRobot.start();
    await odd.stop();
    assert.match(odd.words, /I don't use it/);
  });

  test('a cancelled calibration leaves nothing behind, and Stop is always there', async () => {
    const robot = await RealRobot.start();
    try {
      const { page, heard } = await openEditor(browser, robot, { locale: 'es-ES' });
      await openWizard(page);
      await page.click(id('cal-begin'));
      await until('the wizard at work', () => phase(heard) === 'looking');
      await page.locator(id('cal-now'), { hasText: /[áéí¡ ]/ }).waitFor();
      await page.click(id('cal-cancel'));
      await until('the end of the wizard', () => phase(heard) === 'off');
      await page.locator('dialog').waitFor({ state: 'detached' });
      await page.click(on.flag);
      await until('a running program', () => heard.telemetry.state === 'running');
      await page.click(on.stop);
      await until('a stopped program', () => heard.telemetry.state === 'idle');
      assert.deepEqual(page.problems, []);
      await page.context().close();
    } finally {
      await robot.stop();
    }
  });

  test('a reload in the middle goes on where it was', async () => {
    const robot = await RealRobot.start();
    try {
      const { page, heard } = await openEditor(browser, robot);
      await openWizard(page);
      await page.click(id('cal-begin'));
      await until('the wizard at work', () => phase(heard) === 'looking');
      await page.reload();
      await page.locator(id('cal-picture')).waitFor({ timeout: 60_000 });
      await page.context().close();
    } finally {
      await robot.stop();
    }
  });

  test(
    'real photographs give the lens that they were taken with',
    { skip: !existsSync(photographs) },
    async () => {
      const pictures = join(folder, 'pictures');
      mkdirSync(pictures);
      for (let i = 1; i <= 14; i++) {
        if (i === 10) continue;
        const name = `left${String(i).padStart(2, '0')}`;
        // Each for two seconds, as a hand that holds the board still.
        for (let k = 0; k < 40; k++) {
          symlinkSync(
            join(photographs, `${name}.jpg`),
            join(pictures, `${name}-${String(k).padStart(2, '0')}.jpg`),
          );
        }
      }
      const robotFile = join(folder, 'robot.json');
      copyFileSync(`${root}runtime/model/robots/mirada-sim.json`, robotFile);
      const robot = await RealRobot.start('--camera', pictures, '--robot', robotFile);
      try {
        const { page, heard } = await openEditor(browser, robot);
        await openWizard(page);
        await page.click(id('cal-begin'));
        await until(
          'ten views',
          () => heard.messages.some((m) => m.type === 'calibration' && m.views >= 10),
          120,
        );
        if (phase(heard) === 'looking') await page.click(id('cal-finish')).catch(() => undefined);
        await page.locator(id('cal-save')).waitFor({ timeout: 240_000 });
        await page.click(id('cal-save'));
        await page.locator(id('cal-words'), { hasText: 'Saved in' }).waitFor({ timeout: 60_000 });
        const camera = json(join(folder, 'robot.camera.json'));
        assert.ok(Math.abs(camera.fx_px - 532.8) < 4, `fx ${camera.fx_px}`);
        assert.ok(camera.calibration.rms_px < 0.22, `rms ${camera.calibration.rms_px}`);
        await page.context().close();
      } finally {
        await robot.stop();
      }
    },
  );
});
