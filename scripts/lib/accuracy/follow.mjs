// Following: what build/bench/bin/follow_accuracy prints.
export const order = 50;

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const percent = (value) => `${(100 * value).toFixed(0)} %`;

export function section({ seconds, runs }) {
  const walks = [...new Set(runs.map(({ walk }) => walk))];
  const row = (walk) => {
    const mine = runs.filter((run) => run.walk === walk);
    const good = mine.filter((run) => run.both >= 0.9).length;
    const found = mine.filter((run) => Math.abs(run.end_off_m) < 0.4).length;
    const touched = mine.filter((run) => run.contacts > 0).length;
    return `| ${walk}, ${mine[0].speed_mps} m/s | ${percent(mean(mine.map((run) => run.in_view)))} | ${percent(mean(mine.map((run) => run.at_distance)))} | ${good} of ${mine.length} | ${found} of ${mine.length} | ${touched} |`;
  };
  return `## Following somebody
*Follow the person at 100 cm* in an empty room of 8 x 8 m, ${seconds} simulated seconds a run, people of 0.9 to 1.1 m (a camera 20 cm high sees higher faces only from farther away), the way by chance with turns of up to 100°; the first 6 seconds do not count. In view: within 10° of the picture's middle. At distance: 0.8 to 1.2 m.

| the walker | in view | at distance | both for 90 % of the time | with them at the end | runs with contact |
|---|---|---|---|---|---|
${walks.map(row).join('\n')}`;
}
