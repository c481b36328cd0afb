// Avoid the obstacles: what build/bench/bin/accuracy prints.
export const order = 10;

export function section({ seconds, verdict, runs }) {
  const rooms = [...new Set(runs.map((run) => run.world))];
  const yes = (truth) => (truth ? 'yes' : '**no**');
  const room_row = (room) => {
    const mine = runs.filter((run) => run.world === room);
    const least = (field) => Math.min(...mine.map((run) => run[field]));
    const clean = mine.filter((run) => run.contacts === 0).length;
    return `| ${room} | ${clean} of ${mine.length} | ${least('path_m').toFixed(1)} m | ${least('cells')} |`;
  };
  const run_row = (run) =>
    `| ${run.world} | ${run.seed} | ${run.contacts} | ${run.path_m.toFixed(1)} | ${run.cells} | ${run.first_contact} |`;

  return `## Avoid the obstacles
The example that every child sees first, ${seconds} simulated seconds a run, driven by what the camera sees alone.

| room | runs without contact | shortest way | fewest 25 cm squares |
|---|---|---|---|
${rooms.map(room_row).join('\n')}

- At most one run with a contact in each room: ${yes(verdict.at_most_one_in_each_room)}.
- Every run at least 5 m long and through at least 25 squares: ${yes(verdict.every_run_5_m_and_25_cells)}.

| room | seed | contacts | way, m | squares | first contact |
|---|---|---|---|---|---|
${runs.map(run_row).join('\n')}`;
}
