// node peer.mjs FOLDER scratch|turbowarp PROGRAM SIZE: one measurement after a warm-up; one line of JSON. Turbo
// mode, no renderer, steps back to back.
import { engine } from './engines.mjs';
import { programs } from './programs.mjs';

const [folder, kind, name, size] = process.argv.slice(2);
const program = programs[name];
const say = console.log;
for (const word of ['log', 'warn', 'error', 'info', 'debug']) console[word] = () => {};

function values(machine) {
  const all = Object.values(machine.runtime.getTargetForStage().variables);
  return Object.fromEntries(all.filter((one) => one.type === '').map((one) => [one.name, one.value]));
}

/** Runs to the end; an endless program until it has counted up to its size. */
async function measure(n) {
  const machine = engine(kind, folder);
  await machine.loadProject(program.build(n).text());
  machine.setTurboMode(true);
  machine.runtime.currentStepTime = 1000 / 60;
  if (machine.runtime.frameLoop) machine.runtime.frameLoop.running = true;
  const before = process.cpuUsage();
  machine.greenFlag();
  const done = () => (program.endless ? values(machine).v * 2 >= n : Number(values(machine).fin) === 1);
  while (!done()) machine.runtime._step();
  const used = process.cpuUsage(before);
  const end = values(machine);
  machine.stopAll();
  return { blocks: program.endless ? end.v * 2 : program.blocks(n), cpu_s: (used.user + used.system) / 1e6, variables: end };
}

const n = Number(size);
await measure(name === 'fib' ? Math.round(n * 0.75) : Math.ceil(n / 10));
say(JSON.stringify(await measure(n)));
process.exit(0);
