/** What the robot remembers, from above: the robot in the middle, its front up. */
import { veil } from '../blocks/colour';
import type { Memory, Point } from '../wire/protocol';

type Pen = CanvasRenderingContext2D;
const turn = Math.PI / 180;
/** What is drawn reaches at least so far, then the next, so that the plot does not breathe. */
const reaches_m = [2.6, 3.6, 5.2, 7.2];
const fades_s = 60;

export interface MemoryView {
  scale: number;
  reach_m: number;
  middle: Point;
}

/** How far from the robot the farthest thing is that is remembered. */
function farthest_m({ robot, places, segments, things }: Memory): number {
  const points: Point[] = [
    ...places.map(([x, y]): Point => [x, y]),
    ...segments.flatMap(([x1, y1, x2, y2]): Point[] => [
      [x1, y1],
      [x2, y2],
    ]),
    ...things.map(([, , x, y]): Point => [x, y]),
  ];
  return points.reduce((most, [x, y]) => Math.max(most, Math.hypot(x - robot.x_m, y - robot.y_m)), 0);
}

export function memoryView(w: number, h: number, memory: Memory): MemoryView {
  const far_m = farthest_m(memory) + 0.1;
  const reach_m = reaches_m.find((reach) => far_m <= reach) ?? reaches_m.at(-1)!;
  return { scale: Math.min(w, h) / 2 / reach_m, reach_m, middle: [w / 2, h / 2] };
}

/** A place of the odometry on the canvas: seen from the robot, its front up, its left to the left. */
export function onCanvas(view: MemoryView, robot: Memory['robot'], [x_m, y_m]: Point): Point {
  const angle = robot.heading_deg * turn;
  const dx = x_m - robot.x_m;
  const dy = y_m - robot.y_m;
  const ahead = dx * Math.cos(angle) + dy * Math.sin(angle);
  const left = dy * Math.cos(angle) - dx * Math.sin(angle);
  return [view.middle[0] - left * view.scale, view.middle[1] - ahead * view.scale];
}

/** A direction from the robot (left positive) and a distance, on the canvas. */
function polar(view: MemoryView, bearing_deg: number, distance_m: number): Point {
  const angle = bearing_deg * turn;
  const r = distance_m * view.scale;
  return [view.middle[0] - r * Math.sin(angle), view.middle[1] - r * Math.cos(angle)];
}

/** How strongly something of this age is drawn: 1 when just seen. */
export function strength(age_s: number): number {
  return Math.max(0.18, 1 - age_s / fades_s);
}

function drawFree(pen: Pen, view: MemoryView, free: number[], colour: string): void {
  if (free.length === 0) return;
  pen.beginPath();
  free.forEach((free_m, i) => {
    const [x, y] = polar(view, (i * 360) / free.length, Math.min(free_m, view.reach_m));
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
  pen.closePath();
  pen.fillStyle = veil(colour, 0.14);
  pen.fill();
}

function drawRings(pen: Pen, view: MemoryView): void {
  pen.lineWidth = 1;
  pen.strokeStyle = 'rgba(31, 42, 68, 0.16)';
  pen.fillStyle = 'rgba(31, 42, 68, 0.5)';
  pen.font = '11px sans-serif';
  for (let ring = 1; ring < view.reach_m; ring += 1) {
    pen.beginPath();
    pen.arc(view.middle[0], view.middle[1], ring * view.scale, 0, 2 * Math.PI);
    pen.stroke();
    pen.fillText(`${ring} m`, view.middle[0] + 3, view.middle[1] - ring * view.scale - 3);
  }
}

function drawCone(pen: Pen, view: MemoryView, robot: Memory['robot'], colour: string): void {
  const [x, y] = view.middle;
  const half = (robot.hfov_deg / 2) * turn;
  const middle = -Math.PI / 2 - robot.pan_deg * turn;
  pen.beginPath();
  pen.moveTo(x, y);
  pen.arc(x, y, 1.6 * view.scale, middle - half, middle + half);
  pen.closePath();
  pen.fillStyle = veil(colour, 0.16);
  pen.fill();
}

function drawNext(pen: Pen, view: MemoryView, { next }: Memory, colour: string): void {
  if (next.watching === 'nothing') return;
  const [x, y] = polar(view, next.pan_deg, 1.5);
  pen.beginPath();
  pen.moveTo(view.middle[0], view.middle[1]);
  pen.lineTo(x, y);
  pen.setLineDash([5, 4]);
  pen.lineWidth = 2;
  pen.strokeStyle = colour;
  pen.stroke();
  pen.setLineDash([]);
  pen.beginPath();
  pen.arc(x, y, next.moving ? 5 : 3.5, 0, 2 * Math.PI);
  pen.fillStyle = colour;
  pen.fill();
}

/** Age is drawn as fading, uncertainty as width. */
function drawPlaces(pen: Pen, view: MemoryView, memory: Memory, colour: string): void {
  pen.lineCap = 'round';
  for (const [x1, y1, x2, y2, sigma_m, age_s] of memory.segments) {
    const from = onCanvas(view, memory.robot, [x1, y1]);
    const to = onCanvas(view, memory.robot, [x2, y2]);
    pen.beginPath();
    pen.moveTo(...from);
    pen.lineTo(...to);
    pen.lineWidth = Math.min(24, Math.max(2, 2 * sigma_m * view.scale));
    pen.strokeStyle = veil(colour, 0.45 * strength(age_s));
    pen.stroke();
  }
  for (const [x_m, y_m, sigma_m, age_s] of memory.places) {
    const [x, y] = onCanvas(view, memory.robot, [x_m, y_m]);
    pen.beginPath();
    pen.arc(x, y, Math.min(12, Math.max(1.6, sigma_m * view.scale * 0.5)), 0, 2 * Math.PI);
    pen.fillStyle = veil(colour, 0.6 * strength(age_s));
    pen.fill();
  }
}

const ink = (share: number) => `rgba(31, 42, 68, ${share})`;

/** Two eyes and a mouth. */
function drawSmile(pen: Pen, x: number, y: number): void {
  pen.beginPath();
  for (const side of [-3.5, 3.5]) {
    pen.moveTo(x + side + 1.4, y - 2.5);
    pen.arc(x + side, y - 2.5, 1.4, 0, 2 * Math.PI);
  }
  pen.fill();
  pen.beginPath();
  pen.arc(x, y, 5.5, 0.2 * Math.PI, 0.8 * Math.PI);
  pen.stroke();
}

/** Where a face, a tag (with its number) or a ball was seen last; the circle is as large as that is unsure. */
function drawThings(pen: Pen, view: MemoryView, memory: Memory): void {
  for (const [kind, id, x_m, y_m, sigma_m, age_s] of memory.things) {
    const share = strength(age_s);
    const [x, y] = onCanvas(view, memory.robot, [x_m, y_m]);
    pen.beginPath();
    pen.arc(x, y, Math.min(30, Math.max(11, sigma_m * view.scale)), 0, 2 * Math.PI);
    pen.fillStyle =
      kind === 'red_ball' ? `rgba(214, 40, 40, ${0.8 * share})` : `rgba(255, 255, 255, ${0.85 * share})`;
    pen.fill();
    pen.lineWidth = 1.5;
    pen.strokeStyle = pen.fillStyle = ink(share);
    pen.stroke();
    if (kind === 'face') drawSmile(pen, x, y);
    if (kind === 'tag') {
      pen.font = '800 11px sans-serif';
      pen.textAlign = 'center';
      pen.textBaseline = 'middle';
      pen.fillText(String(id), x, y);
      pen.textAlign = 'start';
      pen.textBaseline = 'alphabetic';
    }
  }
}

function drawRobot(pen: Pen, view: MemoryView, robot: Memory['robot']): void {
  const [x, y] = view.middle;
  const r = Math.max(5, 0.09 * view.scale);
  pen.beginPath();
  pen.arc(x, y, r, 0, 2 * Math.PI);
  pen.fillStyle = '#1f2a44';
  pen.fill();
  const [eye_x, eye_y] = polar(view, robot.pan_deg, (0.45 * r) / view.scale);
  pen.beginPath();
  pen.arc(eye_x, eye_y, r * 0.45, 0, 2 * Math.PI);
  pen.fillStyle = 'white';
  pen.fill();
}

export function drawMemory(pen: Pen, view: MemoryView, memory: Memory, colour: string): void {
  drawFree(pen, view, memory.free, colour);
  drawRings(pen, view);
  drawCone(pen, view, memory.robot, '#e6a000');
  drawPlaces(pen, view, memory, colour);
  drawThings(pen, view, memory);
  drawNext(pen, view, memory, colour);
  drawRobot(pen, view, memory.robot);
}
