#!/usr/bin/env node
// The seven programs on Scratch, TurboWarp and Mirada, interleaved; prints JSON and keeps it in
// build/peers/results.json.
//   node tests/bench/peers/run.mjs [--reps 5] [--mirada build/release/bin/mirada] [--only fib,sieve] [--table]
// Ours is `mirada run`, its start included; with --vm build/bench/bin/bench_vm it is the machine alone, without its
// start, as the peers are measured.
// --table writes the medians into docs/performance.md. Needs node 18+ and, the first time, npm's registry.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { install } from './install.mjs';
import { programs } from './programs.mjs';
import { writeTable } from './table.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, '../../..');
const folder = `${root}/build/peers`;
const kinds = ['scratch', 'turbowarp', 'mirada'];
const kTickBlocks = 20_000; // block executions of a tick of 20 ms, DESIGN section 4

const { values: options } = parseArgs({
  options: {
    reps: { type: 'string', default: '5' },
    mirada: { type: 'string', default: `${root}/build/release/bin/mirada` },
    vm: { type: 'string' },
    only: { type: 'string' },
    table: { type: 'boolean', default: false },
  },
});

/** CPU seconds that a shell's children have used: the last line of its `times`. */
function childSeconds(text) {
  const [user, system] = text.trim().split('\n').at(-1).split(' ');
  const read = (word) => Number(word.split('m')[0]) * 60 + Number.parseFloat(word.split('m')[1]);
  return read(user) + read(system);
}

/** The machine alone: CPU time without the start. */
function measureMachine(file, seconds) {
  const ticks = Math.ceil(seconds / 0.02);
  const run = JSON.parse(execFileSync(options.vm, ['--ticks', String(ticks), file], { encoding: 'utf8' }));
  return { block_executions: run.blocks, cpu_s: run.cpu_s, variables: run.variables };
}

/** The whole program `mirada run`, its start and its reading included. */
function measureProgram(file, seconds) {
  const words = ['-c', '"$0" run "$1" --world none --seconds "$2" --report -; times >&2', options.mirada, file, String(seconds)];
  const run = spawnSync('sh', words, { encoding: 'utf8' });
  return { ...JSON.parse(run.stdout), cpu_s: childSeconds(run.stderr) };
}

function measureMirada(name, n) {
  const program = programs[name];
  const file = `${folder}/${name}.json`;
  writeFileSync(file, program.build(n).text());
  const seconds = program.endless ? (n / kTickBlocks) * 0.02 : 86_400;
  const report = options.vm ? measureMachine(file, seconds) : measureProgram(file, seconds);
  const blocks = program.endless ? report.variables.v * 2 : program.blocks(n);
  if (Math.abs(report.block_executions - blocks) > 0.01 * blocks) throw new Error(`${name}: counted ${report.block_executions}, not ${blocks}`);
  return { blocks, cpu_s: report.cpu_s, variables: report.variables };
}

function measure(kind, name, n) {
  if (kind === 'mirada') return measureMirada(name, n);
  return JSON.parse(execFileSync('node', [`${here}/peer.mjs`, folder, kind, name, String(n)], { encoding: 'utf8' }));
}

/** All engines must give the same values for a size that all can do. */
function checkSame(name) {
  if (programs[name].endless) return;
  const n = Math.ceil(programs[name].sizes.scratch / (name === 'fib' ? 1 : 5));
  const texts = kinds.map((kind) => {
    const sorted = Object.entries(measure(kind, name, n).variables).sort();
    return JSON.stringify(sorted.map(([key, value]) => [key, String(value)]));
  });
  if (new Set(texts).size > 1) throw new Error(`${name}: the results differ\n${texts.join('\n')}`);
}

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1];

install(folder);
mkdirSync(folder, { recursive: true });
const names = options.only ? options.only.split(',') : Object.keys(programs);
for (const name of names) checkSame(name);
const speeds = Object.fromEntries(names.map((name) => [name, Object.fromEntries(kinds.map((kind) => [kind, []]))]));
for (let rep = 0; rep < Number(options.reps); ++rep) {
  for (const name of names) {
    for (const kind of kinds) {
      const { blocks, cpu_s } = measure(kind, name, programs[name].sizes[kind]);
      speeds[name][kind].push(blocks / cpu_s / 1e6);
    }
  }
}
const rows = names.map((name) => {
  const medians = Object.fromEntries(kinds.map((kind) => [kind, median(speeds[name][kind])]));
  return {
    program: name, title: programs[name].title, mblocks_per_cpu_s: medians, all: speeds[name],
    times_scratch: medians.mirada / medians.scratch, times_turbowarp: medians.mirada / medians.turbowarp,
  };
});
const results = { bench: 'peers', reps: Number(options.reps), machine: `${cpus()[0].model}, ${cpus().length} cores, node ${process.versions.node}`, rows };
const text = JSON.stringify(results, null, 1);
writeFileSync(`${folder}/results.json`, text);
console.log(text);
if (options.table) writeTable(`${root}/docs/performance.md`, results);
