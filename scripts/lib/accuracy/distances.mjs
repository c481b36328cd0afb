// Distances: what `mirada lab distances --json` prints.
export const order = 20;

const percent = (share) => (share === null ? '-' : (100 * share).toFixed(1));
const row = (r) =>
  `| ${r.name} | ${r.errors} | ${percent(r.median_error)} | ${percent(r.p90_error)} | ${percent(r.bias_to_1m)} | ` +
  `${percent(r.missed)} | ${percent(r.imagined)} | ${percent(r.not_seen)} | ${percent(r.within_95)} | ` +
  `${percent(r.paper_median_error)} | ${percent(r.paper_bias)} |`;
const head = (title) =>
  `| ${title} | answers | median | p90 | bias to 1 m | missed | imagined | not seen | in 95 % | paper's median | paper's bias |
|---|---|---|---|---|---|---|---|---|---|---|`;

const goals = [
  ['median error', 'median_error', (x) => x <= 0.02, 'at most 2 %'],
  ['90th percentile', 'p90_error', (x) => x <= 0.06, 'at most 6 %'],
  ['an obstacle reported as clear', 'missed', (x) => x <= 0.01, 'at most 1 % of bearings'],
  ['clear reported as blocked', 'imagined', (x) => x <= 0.02, 'at most 2 % of bearings'],
  ['truth inside the stated 95 % interval', 'within_95', (x) => x >= 0.93 && x <= 0.97, '93 to 97 %'],
  ['bias to 1 m', 'bias_to_1m', (x) => Math.abs(x) < 0.01, 'less than 1 %'],
];

export function section({ tables }) {
  const all = tables[0].rows[0];
  const goal = ([name, field, met, wanted]) =>
    `| ${name} | ${percent(all[field])} % | ${wanted} | ${met(all[field]) ? 'yes' : '**no**'} |`;
  return `## Distances
Rooms made by chance (\`mirada lab distances\`): camera 20 cm high, 22 degrees down, 320x240, obstacles to 1.5 m; what the columns mean stands in [calibration.md](calibration.md). All figures in percent.

| what | measured | wanted | met |
|---|---|---|---|
${goals.map(goal).join('\n')}

![Errors by distance, bearing, floor and light](accuracy/distances.svg)

${tables.map((table) => `${head(table.by)}\n${table.rows.map(row).join('\n')}`).join('\n\n')}`;
}
