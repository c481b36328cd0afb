// A camera that is pulled out and put back while a program drives by it, on the real server.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { launch, on, openPage } from './support/browser.mjs';
import { RealRobot, listen, until } from './support/real_robot.mjs';

const folder = mkdtempSync(join(tmpdir(), 'mirada-camera-'));
const pictures = join(folder, 'pictures');
const away = join(folder, 'away');

/** Some pictures of a room with floor to drive on, as a robot in it sees them. */
async function takePictures(browser) {
  mkdirSync(pictures);
  const robot = await RealRobot.start();
  const page = await openPage(browser);
  const taken = [];
  page.on('websocket', (socket) => {
    socket.on('framereceived', ({ payload }) => {
      if (typeof payload !== 'string') taken.push(payload.subarray(4 + payload.readUInt32LE(0)));
    });
  });
  await page.goto(robot.url);
  await until('four pictures', () => taken.length >= 4, 60);
  taken.slice(0, 4).forEach((jpeg, i) => writeFileSync(join(pictures, `${i}.jpg`), jpeg));
  await page.context().close();
  await robot.stop();
}

describe('a camera that is pulled out and put back', { timeout: 300_000 }, () => {
  let browser;
  before(async () => {
    browser = await launch();
    await takePictures(browser);
  });
  after(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });

  test('stops the robot, says so, leaves no old number, and comes back by itself', async () => {
    const robot = await RealRobot.start('--camera', pictures);
    const page = await openPage(browser);
    const heard = listen(page);
    try {
      await page.goto(robot.url);
      await page.locator(`${on.flag}:not([disabled])`).waitFor({ timeout: 60_000 });
      await until('an answer of the eyes', () => heard.telemetry?.sonar);
      await page.click(on.flag);
      await until('a running program', () => heard.telemetry.state === 'running');
      renameSync(pictures, away);
      await until('a safe stop', () => heard.telemetry.state === 'idle', 30);
      assert.equal(heard.telemetry.stop_reason, 'camera_lost');
      assert.deepEqual(heard.telemetry.wheels, { left_mps: 0, right_mps: 0 });
      await until('no old number', () => heard.telemetry.sonar === null);
      assert.notEqual(heard.telemetry.camera_trouble, '');
      await page.locator('.over-picture', { hasText: /\w/ }).waitFor();
      renameSync(away, pictures);
      await until('pictures again', () => heard.telemetry.camera_trouble === '' && heard.telemetry.sonar, 30);
      assert.equal(heard.telemetry.state, 'idle', 'nothing moves again by itself');
      await page.locator('.over-picture').waitFor({ state: 'detached' });
      assert.deepEqual(page.problems, []);
    } finally {
      await page.context().close();
      await robot.stop();
    }
  });
});
