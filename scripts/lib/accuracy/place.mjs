// Where the robot believes to be: what build/bench/bin/memory_accuracy place prints.
export const order = 18;

const names = {
  start: 'only where it starts (wheels)',
  lines: 'the painted lines',
  tags: 'the tags',
  'lines and tags': 'both',
};

const middle = (values, share = 0.5) => [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))];
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const cm = (metres) => `${(100 * metres).toFixed(1)} cm`;
const percent = (share) => `${(100 * share).toFixed(0)} %`;

function row(runs, knows) {
  const mine = runs.filter((run) => run.knows === knows);
  const all = (what) => mine.map((run) => run[what]);
  const worst = Math.max(...all('off_worst_m'));
  return `| ${names[knows]} | ${percent(mean(all('known')))} | ${cm(middle(all('off_median_m')))} | ${cm(middle(all('off_p90_m')))} | ${cm(worst)} | ${middle(all('off_median_deg')).toFixed(1)}° | ${cm(middle(all('possible_median_m')))} | ${percent(mean(all('honest')))} |`;
}

function carriedRow(carried, knows) {
  const mine = carried.filter((run) => run.knows === knows);
  const lost = mine.filter((run) => run.lost_s !== null).map((run) => run.lost_s);
  const back = mine.filter((run) => run.back_s !== null).length;
  const wrong = mine.filter((run) => run.wrong_after_s > 0).length;
  const after = lost.length ? `${middle(lost).toFixed(1)} s (${Math.max(...lost).toFixed(1)} s)` : '';
  return `| ${names[knows]} | ${lost.length} of ${mine.length} | ${after} | ${back} | ${wrong} |`;
}

export function section({ runs, carried }) {
  const kinds = Object.keys(names);
  const path = mean(runs.map((run) => run.path_m));
  return `## Where am I
The robot drives and avoids in the green field for a minute (${path.toFixed(1)} m), on wheels whose sizes are 1 % wrong, and tells twice a second where it believes to be on the map of \`place.json\`; ${runs.length / kinds.length} seeds. *Off*: median and nine of ten of a run, the median
run; and the worst of all. *Possible error*: what the block says, two sigmas; *within it*: how often it was no farther off. Only while it says that it knows.

| knows | says that it knows | off | nine of ten | worst | heading off | possible error | within it |
|---|---|---|---|---|---|---|---|
${kinds.map((knows) => row(runs, knows)).join('\n')}

Carried away after 10 s to a random place, watched for 30 s more. *Wrong after*: said again that it knows, 30 cm or more off. Lines look alike, so by lines alone it stays lost until it is put back.

| knows | said that it is lost | after, median (longest) | knew again | wrong after |
|---|---|---|---|---|
${kinds.slice(1).map((knows) => carriedRow(carried, knows)).join('\n')}

- **Weakness**: the simulated camera hangs exactly as \`robot.json\` says; a real one's tilt error is in the possible error (0.5° of it), but not measured here.`;
}
