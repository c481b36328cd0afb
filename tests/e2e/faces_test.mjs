// Who the robot knows: the teacher's switch, the list, another name, forgotten in one click, on the real server.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { launch, on, openPage } from './support/browser.mjs';
import { RealRobot, until } from './support/real_robot.mjs';

const person = (name) => ({ name, kind: 'network-1', looks: [{ feature: [1, 0, 0] }] });

describe('known faces', { timeout: 180_000 }, () => {
  const folder = mkdtempSync(join(tmpdir(), 'mirada-faces-'));
  const file = join(folder, 'known.json');
  const kept = () => JSON.parse(readFileSync(file, 'utf8'));
  let browser, robot, page;
  before(async () => {
    const people = [person('Ana'), person('Zoe')];
    writeFileSync(file, JSON.stringify({ format: 'mirada-faces', version: 1, allowed: false, people }));
    browser = await launch();
    robot = await RealRobot.start('--known-faces', file);
    page = await openPage(browser);
    await page.goto(robot.url);
    await page.locator(`${on.flag}:not([disabled])`).waitFor({ timeout: 60_000 });
  });
  after(async () => {
    await browser.close();
    await robot.stop();
    rmSync(folder, { recursive: true });
  });

  test('are off until a teacher types the code, and off again without it', async () => {
    await page.click('[data-testid=known-faces]');
    const allow = page.locator('[data-testid=faces-allow]');
    assert.equal(await allow.getAttribute('aria-checked'), 'false');
    assert.ok(await allow.isDisabled(), 'no code, no switch');
    await page.fill('[data-testid=faces-code]', 'AAAAAA');
    await allow.click();
    await page.locator('[data-testid=faces-refused]', { hasText: /\w/ }).waitFor();
    assert.equal(kept().allowed, false);
    const [, code] = /code is (\S+)/.exec(robot.words);
    await page.fill('[data-testid=faces-code]', code);
    await allow.click();
    await page.locator('[data-testid=faces-allow][aria-checked=true]').waitFor();
    assert.equal(kept().allowed, true);
    await allow.click();
    await page.locator('[data-testid=faces-allow][aria-checked=false]').waitFor();
    assert.equal(kept().allowed, false);
  });

  test('get another name, and are forgotten in one click', async () => {
    const people = page.locator('[data-testid=faces-people] input');
    await people.first().fill('Eva');
    await page.locator('[data-testid=faces-people] button[type=submit]').first().click();
    await until('the new name', () => kept().people.some(({ name }) => name === 'Eva'));
    assert.ok(!readFileSync(file, 'utf8').includes('Ana'));
    await page.getByRole('button', { name: 'Forget Zoe' }).click();
    await until('one is left', () => kept().people.length === 1);
    await page.click('[data-testid=faces-forget-all]');
    await until('nobody is left', () => kept().people.length === 0);
    await until('an empty list', async () => (await people.count()) === 0);
    assert.ok(existsSync(file));
    assert.deepEqual(page.problems, []);
  });
});
