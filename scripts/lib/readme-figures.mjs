// Puts the table of measured figures into README.md: node readme-figures.mjs FOLDER, whose *.json scripts/bench wrote.
import { readFileSync, writeFileSync } from 'node:fs';
import { cpus, totalmem } from 'node:os';

const folder = process.argv[2];
const read = (name) => JSON.parse(readFileSync(`${folder}/${name}.json`, 'utf8'));
const [sonar, lockstep, control, server, page] = ['sonar', 'lockstep', 'control', 'server', 'page'].map(read);

const ms = (us) => `${(us / 1000).toFixed(3)} ms`;
const seeing = ({ sonar_us, canny_us, paper_us }) => `${ms(sonar_us)} | ${ms(canny_us)}, the paper's method ${ms(paper_us)}`;
const speeds = (program) =>
  lockstep.runs.filter((run) => run.program.includes(program)).map((run) => run.times_real_time_cpu);
const least = (program) => `at least ${Math.floor(Math.min(...speeds(program)))} times`;
const p99 = (spread) => `${(spread.p99 ?? spread.p99_ms).toFixed(1)} ms`;

const rows = [
  ['Visual sonar, rendered 320x240, floor model updated', seeing(sonar.rendered_320x240)],
  ['The same on Debian\'s photographs', seeing(sonar.photographs_320x240)],
  ['*Avoid the obstacles* in lockstep, one core, three rooms', `${least('avoid')} real time |`],
  ['*Look for a face* in lockstep', `${least('greet')} real time |`],
  ['Stop to zero command, 10 viewers streaming, p99', `${p99(server.stop_by_socket_ms)} | by POST ${p99(server.stop_by_post_ms)}`],
  ['Frame to motor command through a block program, p99', `${p99(control.frame_to_command)} | a frame comes every 50 ms`],
  ['Start to serving', `${server.start_to_ready_s.toFixed(2)} s |`],
  ['Idle server, nobody there', `${server.idle_cpu_percent.toFixed(1)} % of a core |`],
  ['First page of the editor, compressed', `${Math.round(page.gzip_bytes / 1000)} kB |`],
];

const machine = `${cpus().length} cores of ${cpus()[0].model.trim()}, ${Math.round(totalmem() / 2 ** 30)} GiB, Debian 12`;
const table = `Measured by \`scripts/bench\` on ${machine}:

| what | figure | beside it, same run |
|---|---|---|
${rows.map(([what, figures]) => `| ${what} | ${figures} |`).join('\n')}`;

const readme = readFileSync('README.md', 'utf8');
const marked = /(<!-- figures -->\n)[\s\S]*?(<!-- end of figures -->)/;
if (!marked.test(readme)) throw new Error('README.md has no marks for the figures');
writeFileSync('README.md', readme.replace(marked, (_, before, after) => `${before}${table}\n${after}`));
