// Out of the corner: what build/bench/bin/memory_accuracy corner prints.
export const order = 16;

export function section({ runs }) {
  const yes = (truth) => (truth ? 'yes' : '**no**');
  const row = (name, memory) => {
    const mine = runs.filter((run) => run.memory === memory);
    const count = (test) => mine.filter(test).length;
    const far = mine.map((run) => run.end_m).sort((a, b) => a - b)[Math.floor(mine.length / 2)];
    return `| ${name} | ${count((run) => run.left)} of ${mine.length} | ${count((run) => run.crossings > 0)} | ${count((run) => run.looked)} | ${far.toFixed(2)} m |`;
  };
  const all = runs.filter((run) => run.memory).every((run) => run.left);
  return `## Out of the corner
Exercise 5.3 of Vega and Cañas: two field lines, which must not be crossed, meet at a right angle. The robot drives in with its camera ahead and stops before them; the ways out are behind its view. It asks
*is the way to … clear?* from 180° on and takes the first that is. *Forgotten*: the same program with *forget everything* before it asks.

| | left the corner | crossed a line | looked again | from the corner at the end, median |
|---|---|---|---|---|
${row('with memory', true)}
${row('forgotten', false)}

- All leave it by memory: ${yes(all)}.`;
}
