// Writes a table between its two marks in a page.
import { readFileSync, writeFileSync } from 'node:fs';

const kStart = '<!-- peers: written by tests/bench/peers/run.mjs --table -->';
const kEnd = '<!-- peers end -->';

const three = (number) => (number >= 100 ? number.toFixed(0) : number.toPrecision(3));

export function writeTable(file, results) {
  const head = ['program', 'Scratch', 'TurboWarp', 'Mirada', 'x Scratch', 'x TurboWarp'];
  const rows = results.rows.map((row) => {
    const speeds = ['scratch', 'turbowarp', 'mirada'].map((kind) => three(row.mblocks_per_cpu_s[kind]));
    return [row.title, ...speeds, three(row.times_scratch), three(row.times_turbowarp)];
  });
  const lines = [head, head.map(() => '---'), ...rows].map((cells) => `| ${cells.join(' | ')} |`);
  const page = readFileSync(file, 'utf8');
  const [from, to] = [page.indexOf(kStart), page.indexOf(kEnd)];
  if (from < 0 || to < from) throw new Error(`${file} lacks the marks of the table`);
  const note = `Medians of ${results.reps} on ${results.machine}.`;
  writeFileSync(file, `${page.slice(0, from)}${kStart}\n${lines.join('\n')}\n\n${note}\n${page.slice(to)}`);
}
