// The real browser: Debian's chromium, driven by the playwright-core of ui/.
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../../../', import.meta.url));
const { chromium } = createRequire(`${root}ui/package.json`)('playwright-core');

const quiet = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

export function launch() {
  const executablePath = process.env.MIRADA_CHROMIUM ?? '/usr/bin/chromium';
  return chromium.launch({ executablePath, headless: true, args: quiet });
}

/** A page that notes all that the browser complains about. */
export async function openPage(browser, { width = 1440, height = 900, locale = 'en-GB' } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, locale });
  const page = await context.newPage();
  page.problems = [];
  page.on('pageerror', (error) => page.problems.push(`${error.message}\n${error.stack ?? ''}`));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) page.problems.push(message.text());
  });
  return page;
}

/** The names by which the tests find things. */
export const on = {
  flag: '[data-testid=flag]',
  stop: '[data-testid=stop]',
  status: '[data-testid=status]',
  banner: '[data-testid=banner]',
  saved: '[data-testid=save-state].saved',
  block: (id) => `.blocklySvg .blocklyBlockCanvas [data-id="${id}"]`,
  category: (name) => `.blocklyToolboxCategory:has-text("${name}")`,
};

/** The path of a block's own outline, without what hangs below it. */
export async function blockBox(page, id) {
  return page.evaluate((wanted) => {
    const group = document.querySelector(`.blocklySvg .blocklyBlockCanvas [data-id="${CSS.escape(wanted)}"]`);
    const path = group?.querySelector(':scope > .blocklyPath');
    const { x, y, width, height } = path.getBoundingClientRect();
    return { x, y, width, height };
  }, id);
}

/** Drags with the pointer in steps, as a hand does. */
export async function drag(page, from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 8, from.y + 4, { steps: 2 });
  await page.mouse.move(to.x, to.y, { steps: 12 });
  await page.waitForTimeout(120);
  await page.mouse.up();
}
