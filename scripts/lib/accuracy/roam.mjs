// Roam and remember beside Avoid the obstacles: what build/bench/bin/accuracy prints of each.
export const order = 15;

const sum = (runs, field) => runs.reduce((total, run) => total + run[field], 0);
const clean = (runs) => runs.filter((run) => run.contacts === 0).length;

export function section({ memory, view }) {
  const minutes = memory.seconds / 60;
  const yes = (truth) => (truth ? 'yes' : '**no**');
  const rooms = [...new Set(memory.runs.map((run) => run.world))];
  const cells = (runs) => (sum(runs, 'cells') / runs.length).toFixed(0);
  const of = ({ runs }, room) => runs.filter((run) => run.world === room);
  const row = (name, a, b) =>
    `| ${name} | ${sum(a, 'contacts')} | ${sum(b, 'contacts')} | ${clean(a)} of ${a.length} | ${clean(b)} of ${b.length} | ${cells(a)} | ${cells(b)} |`;
  const contacts = sum(memory.runs, 'contacts');
  return `## Roam and remember
*Drive and avoid*, which steers by the visual memory, and *Avoid the obstacles*, which knows only what is in view: the
same rooms and seeds, ${minutes} simulated minutes a run. The rooms are the laboratory's (*mirada lab distances*), by floor, light and number; nothing was tuned on them.

| room | contacts | without memory | runs without contact | without memory | 25 cm squares a run | without memory |
|---|---|---|---|---|---|---|
${rooms.map((room) => row(room, of(memory, room), of(view, room))).join('\n')}
${row('all', memory.runs, view.runs)}

- At most one contact in ten runs: ${yes(contacts * 10 <= memory.runs.length)}.
- At least as many squares as without memory: ${yes(sum(memory.runs, 'cells') >= sum(view.runs, 'cells'))}.
- A third of the contacts or fewer: ${yes(contacts * 3 <= sum(view.runs, 'contacts'))}.`;
}
