// Makes docs/accuracy.md: node page.mjs. One section is a result, docs/accuracy/NAME.json, and its words, NAME.mjs
// beside this file, with `order` (sections go by it) and `section(result)` (Markdown that begins with its heading).
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const docs = join(here, '../../../docs');

const names = readdirSync(here)
  .filter((file) => file.endsWith('.mjs') && file !== 'page.mjs')
  .map((file) => basename(file, '.mjs'));
const sections = [];
for (const name of names) {
  const result = join(docs, 'accuracy', `${name}.json`);
  if (!existsSync(result)) continue;
  const { order, section } = await import(`./${name}.mjs`);
  sections.push({ order, text: section(JSON.parse(readFileSync(result, 'utf8'))) });
}
sections.sort((a, b) => a.order - b.order);

const top = `# Accuracy

Written by \`scripts/accuracy\`; measured by the simulated rooms' truth, which no block can read. \`scripts/accuracy NAME\` measures one section again.`;
writeFileSync(join(docs, 'accuracy.md'), [top, ...sections.map(({ text }) => text)].join('\n\n') + '\n');
