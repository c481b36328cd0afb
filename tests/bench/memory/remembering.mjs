// How well the memory remembers, by the truth: node tests/bench/memory/remembering.mjs path/to/mirada
// Five rooms by chance, four seeds each: look around, 2 m of driving, a quarter turn; then each fifth degree out of
// view is asked and compared with what stands there. Walls have a colour of their own. Prints one JSON object.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const mirada = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), 'remembering-'));
const floors = { carpet: '#8c8678', wood: '#b98a5a', tiles: '#c9c4b8', concrete: '#9a9a98', grass: '#5c8a4a' };
const looks = ['plain', 'wood', 'cardboard', 'books', 'drawers', 'crate'];
const bearings = Array.from({ length: 72 }, (_, i) => i * 5 - 175); // right positive
const view_deg = 36;
const floorError_m = 0.08; // what "possible error" says of floor that ends in nothing seen

function chanceOf(seed) {
  let state = seed;
  return (low, high) => {
    state = (state * 1664525 + 1013904223) >>> 0;
    return low + ((high - low) * state) / 2 ** 32;
  };
}

function roomOf(number, floor) {
  const chance = chanceOf(7919 * (number + 1));
  const [w, h] = [chance(3, 4.4) / 2, chance(2.6, 3.6) / 2];
  const things = [];
  for (let tries = 0; things.length < 7 && tries < 300; tries++) {
    const [x_m, y_m] = [chance(-w + 0.3, w - 0.3), chance(-h + 0.3, h - 0.3)];
    const onTheWay = Math.hypot(x_m, y_m) < 0.55 || (Math.abs(y_m) < 0.3 && x_m > 0 && x_m < 1);
    if (onTheWay || things.some((other) => Math.hypot(x_m - other.x_m, y_m - other.y_m) < 0.6)) continue;
    const channel = () => Math.round(chance(20, 230)).toString(16).padStart(2, '0');
    const colour = `#${channel()}${channel()}${channel()}`;
    const round = chance(0, 1) > 0.6;
    if (round) things.push({ x_m, y_m, radius_m: chance(0.06, 0.15), height_m: 0.4, look: 'plain', colour });
    else {
      const look = looks[Math.floor(chance(0, looks.length))];
      const size = { length_m: chance(0.15, 0.4), width_m: chance(0.15, 0.35), height_m: chance(0.2, 0.5) };
      things.push({ x_m, y_m, heading_deg: chance(0, 90), ...size, look, colour });
    }
  }
  const points = [[-w, -h], [w, -h], [w, h], [-w, h], [-w, -h]];
  return {
    format: 'mirada-world', version: 1, id: `by-chance-${number}`, name: { en: 'By chance', es: 'Al azar' },
    bounds: { min_x_m: -w, min_y_m: -h, max_x_m: w, max_y_m: h },
    start: { x_m: 0, y_m: 0, heading_deg: 0 }, floor: { kind: floor, colour: floors[floor] },
    walls: [{ points, skirting_m: 0.08, colour: '#7a8ab0', skirting_colour: '#5a4030' }],
    boxes: things.filter((thing) => !thing.radius_m), cylinders: things.filter((thing) => thing.radius_m),
  };
}

function edgesOf(room) {
  const outline = room.walls[0].points.slice(1).map((to, i) => [room.walls[0].points[i], to]);
  const boxes = room.boxes.flatMap((box) => {
    const [c, s] = [Math.cos((box.heading_deg * Math.PI) / 180), Math.sin((box.heading_deg * Math.PI) / 180)];
    const [l, w] = [box.length_m / 2, box.width_m / 2];
    const corners = [[l, w], [-l, w], [-l, -w], [l, -w]].map(([u, v]) => [box.x_m + c * u - s * v, box.y_m + s * u + c * v]);
    return corners.map((corner, i) => [corner, corners[(i + 1) % 4]]);
  });
  return [...outline, ...boxes];
}

/** From a point to the nearest thing. */
function nearest_m(room, edges, x, y) {
  const straight = edges.map(([[ax, ay], [bx, by]]) => {
    const [ex, ey] = [bx - ax, by - ay];
    const part = Math.max(0, Math.min(1, ((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey)));
    return Math.hypot(x - ax - part * ex, y - ay - part * ey);
  });
  const round = room.cylinders.map((can) => Math.abs(Math.hypot(x - can.x_m, y - can.y_m) - can.radius_m));
  return Math.min(...straight, ...round);
}

/** The segment from a to b, in steps, is nowhere in a thing: what is said to be clear is. */
function isFree(room, edges, [ax, ay], angle, distance_m) {
  const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
  const crosses = edges.some(([[x1, y1], [x2, y2]]) => {
    const [ex, ey] = [x2 - x1, y2 - y1];
    const slant = dx * ey - dy * ex;
    const along = ((x1 - ax) * ey - (y1 - ay) * ex) / slant;
    const part = ((x1 - ax) * dy - (y1 - ay) * dx) / slant;
    return along > 0 && along < distance_m - 0.1 && part >= 0 && part <= 1;
  });
  const inCan = room.cylinders.some((can) => {
    const [fx, fy] = [can.x_m - ax, can.y_m - ay];
    const along = fx * dx + fy * dy;
    return along > 0 && along < distance_m - 0.1 && Math.abs(fy * dx - fx * dy) < can.radius_m;
  });
  return !crosses && !inCan;
}

function programText() {
  let count = 0;
  const block = (type, rest = {}) => ({ type, id: `b${++count}`, ...rest });
  const number = (value) => ({ shadow: { type: 'math_number', fields: { NUM: value } } });
  const set = (name, value) => block('data_setvariableto', { fields: { VARIABLE: { id: name } }, inputs: { VALUE: { block: value } } });
  const drive = (way) => block('motion_drive', { fields: { WAY: way }, inputs: { DISTANCE: number(50) } });
  const ask = (bearing) => [
    set(`d${bearing}`, block('vision_obstacle_distance', { inputs: { ANGLE: number(bearing) } })),
    set(`e${bearing}`, block('memory_known', { fields: { WHAT: 'error' }, inputs: { ANGLE: number(bearing) } })),
  ];
  const blocks = [
    block('event_whenflagclicked', { x: 0, y: 0 }), block('memory_look_around'),
    drive('forward'), drive('backward'), drive('forward'), drive('backward'),
    block('motion_turn', { fields: { SIDE: 'left' }, inputs: { ANGLE: number(90) } }), ...bearings.flatMap(ask),
  ];
  for (let i = blocks.length - 1; i > 0; i--) blocks[i - 1].next = { block: blocks[i] };
  const variables = bearings.flatMap((bearing) => [`d${bearing}`, `e${bearing}`]).map((name) => ({ id: name, name }));
  return JSON.stringify({
    format: 'mirada-program', version: 1, packs: ['events', 'motion', 'memory', 'vision', 'data'],
    workspace: { blocks: { languageVersion: 0, blocks: [blocks[0]] }, variables },
  });
}

const program = join(folder, 'program.json');
writeFileSync(program, programText());
const all = { errors_m: [], inside: 0, clear: 0, clear_but_blocked: 0 };
Object.keys(floors).forEach((floor, number) => {
  const room = roomOf(number, floor);
  const edges = edgesOf(room);
  const file = join(folder, `room-${number}.json`);
  writeFileSync(file, JSON.stringify(room));
  for (let seed = 1; seed <= 4; seed++) {
    const report = JSON.parse(execFileSync(mirada, ['run', program, '--world', file, '--seed', `${seed}`, '--report', '-'], { encoding: 'utf8' }));
    const { x_m, y_m, heading_deg } = report.robot;
    for (const bearing of bearings) {
      const distance_m = Number(report.variables[`d${bearing}`]) / 100;
      const error_m = Number(report.variables[`e${bearing}`]) / 100;
      if (!(distance_m > 0) || Math.abs(bearing) < view_deg) continue;
      const angle = ((heading_deg - bearing) * Math.PI) / 180;
      if (Math.abs(error_m - floorError_m) < 1e-9) {
        all.clear += 1;
        all.clear_but_blocked += isFree(room, edges, [x_m, y_m], angle, distance_m) ? 0 : 1;
        continue;
      }
      const off_m = nearest_m(room, edges, x_m + distance_m * Math.cos(angle), y_m + distance_m * Math.sin(angle));
      all.errors_m.push(off_m);
      all.inside += off_m <= (1.96 * error_m) / 2 ? 1 : 0;
    }
  }
});
const sorted = all.errors_m.sort((a, b) => a - b);
const part = (share) => sorted[Math.floor(share * (sorted.length - 1))];
console.log(JSON.stringify({ remembered: sorted.length, median_m: part(0.5), p90_m: part(0.9), inside_95: all.inside / sorted.length, clear: all.clear, clear_but_blocked: all.clear_but_blocked }));
