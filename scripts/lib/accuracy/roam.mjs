// Roam and remember beside Avoid the obstacles: what build/bench/bin/accuracy prints of each.
export const order = 15;

const sum = (runs, field) => runs.reduce((total, run) => total + run[field], 0);
const clean = (runs) => runs.filter((run) => run.contacts === 0).length;

export function section({ memory, forgets, view }) {
  const minutes = memory.seconds / 60;
  const yes = (truth) => (truth ? 'yes' : '**no**');
  const rooms = [...new Set(memory.runs.map((run) => run.world))];
  const cells = (runs) => (sum(runs, 'cells') / runs.length).toFixed(0);
  const of = ({ runs }, room) => runs.filter((run) => run.world === room);
  const kinds = [memory, forgets, view];
  const row = (name, all) =>
    `| ${name} | ${all.map((runs) => `${sum(runs, 'contacts')} | ${clean(runs)} of ${runs.length} | ${cells(runs)}`).join(' | ')} |`;
  const contacts = sum(memory.runs, 'contacts');
  return `## Roam and remember
*Drive and avoid*, which steers by the visual memory; the same program when the memory keeps no more than the newest
picture shows; and *Avoid the obstacles*, which asks only for what is in view: the same rooms and seeds, ${minutes} simulated
minutes a run. The rooms are the laboratory's (*mirada lab distances*), by floor, light and number; nothing was tuned on them.

| room | contacts | runs without | 25 cm squares a run | same, memory off | runs without | squares | in view only | runs without | squares |
|---|---|---|---|---|---|---|---|---|---|
${rooms.map((room) => row(room, kinds.map((kind) => of(kind, room)))).join('\n')}
${row('all', kinds.map((kind) => kind.runs))}

- At most one contact in ten runs: ${yes(contacts * 10 <= memory.runs.length)}.
- At least as many squares as the same program without memory: ${yes(sum(memory.runs, 'cells') >= sum(forgets.runs, 'cells'))}; as *Avoid the obstacles*: ${yes(sum(memory.runs, 'cells') >= sum(view.runs, 'cells'))}.
- A third of the contacts of the same program without memory, or fewer: ${yes(contacts * 3 <= sum(forgets.runs, 'contacts'))}; of *Avoid the obstacles*: ${yes(contacts * 3 <= sum(view.runs, 'contacts'))}.`;
}
