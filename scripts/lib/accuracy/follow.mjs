// Following: what build/bench/bin/follow_accuracy prints.
export const order = 50;

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const percent = (value) => `${(100 * value).toFixed(0)} %`;

export function section({ seconds, runs }) {
  const walks = [...new Set(runs.map(({ walk }) => walk))];
  const of = (walk) => runs.filter((run) => run.walk === walk);
  const ends = (mine) => mine.filter((run) => Math.abs(run.end_off_m) < 0.4).length;
  const touched = (mine) => mine.filter((run) => run.contacts > 0).length;
  const row = (walk) => {
    const mine = of(walk);
    const good = mine.filter((run) => run.both >= 0.9).length;
    return `| ${walk}, ${mine[0].speed_mps} m/s | ${percent(mean(mine.map((run) => run.in_view)))} | ${percent(mean(mine.map((run) => run.at_distance)))} | ${percent(mean(mine.map((run) => run.both)))} | ${percent(mean(mine.map((run) => run.too_near)))} / ${percent(mean(mine.map((run) => run.too_far)))} | ${good} of ${mine.length} | ${ends(mine)} of ${mine.length} | ${touched(mine)} |`;
  };
  const said = (holds) => (holds ? 'yes' : '**no**');
  const pillar = of('passes behind a pillar');
  const learnt = of('learnt, among printed faces');
  const decoys = learnt.filter((run) => run.longest_poster_s > 3).length;
  const shares = walks.map((walk) => `${walk}: ${said(mean(of(walk).map((run) => run.both)) >= 0.9)}`);
  return `## Following somebody
*Follow the person at 100 cm* in an empty room of 8 x 8 m, ${seconds} simulated seconds a run, people of 0.9 to 1.1 m (a camera 20 cm high sees higher faces only from farther away), the way by chance with turns of up to 100°; the first 6 seconds do not count. In view: within 10° of the picture's middle. At distance: 0.8 to 1.2 m. *Faces the robot*: shows the face all the time, backwards too. *Walks as people do*: looks where they go, so that what is followed is mostly their clothes, which is less sure.

| the walker | in view | at distance | both | too near / too far | both for 90 % of the time | with them at the end | runs with contact |
|---|---|---|---|---|---|---|---|
${walks.map(row).join('\n')}

- In view and at distance for 90 % of the time, in the mean of the runs: ${shares.join('; ')}.
- With them at the end after the pillar in at least 19 of 20: ${said(ends(pillar) >= 0.95 * pillar.length)}.
- Learnt, and no printed face looked at instead for more than 3 s: ${learnt.length - decoys} of ${learnt.length}: ${said(decoys === 0)}.
- No contact: ${said(touched(runs) === 0)}.
- Too near is mostly somebody who walks at the robot: it backs off only on floor that it has seen or driven on, and a face nearer than 0.7 m is above its picture.`;
}
