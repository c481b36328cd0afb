/** The room from above: what stands in it, and the robot with what it sees. */
import { shade, veil } from '../blocks/colour';
import type { Point, Scene, Sonar } from '../wire/protocol';
import type { Pose } from './motion_track';
import type { RoomView } from './room_view';

type Pen = CanvasRenderingContext2D;
const turn = Math.PI / 180;

function trace(pen: Pen, view: RoomView, points: Point[]): void {
  pen.beginPath();
  points.forEach(([x, y], i) =>
    i === 0 ? pen.moveTo(view.x(x), view.y(y)) : pen.lineTo(view.x(x), view.y(y)),
  );
}

function drawFloor(pen: Pen, view: RoomView, scene: Scene): void {
  const { min_x_m, min_y_m, max_x_m, max_y_m } = scene.bounds;
  pen.fillStyle = scene.floor_colour;
  pen.beginPath();
  const w = (max_x_m - min_x_m) * view.scale;
  pen.roundRect(view.x(min_x_m), view.y(max_y_m), w, (max_y_m - min_y_m) * view.scale, 6);
  pen.fill();
}

function drawBox(pen: Pen, view: RoomView, box: Scene['boxes'][number]): void {
  pen.save();
  pen.translate(view.x(box.x_m), view.y(box.y_m));
  pen.rotate(-box.heading_deg * turn);
  const w = box.length_m * view.scale;
  const h = box.width_m * view.scale;
  pen.beginPath();
  pen.roundRect(-w / 2, -h / 2, w, h, Math.min(4, w / 4, h / 4));
  pen.fillStyle = box.colour;
  pen.fill();
  pen.strokeStyle = shade(box.colour, -0.3);
  pen.stroke();
  pen.restore();
}

function disc(pen: Pen, x: number, y: number, radius: number): void {
  pen.beginPath();
  pen.arc(x, y, Math.max(0.5, radius), 0, 2 * Math.PI);
}

/** All that does not move by itself. */
export function drawRoom(pen: Pen, view: RoomView, scene: Scene): void {
  drawFloor(pen, view, scene);
  pen.lineCap = 'butt';
  pen.lineJoin = 'round';
  for (const line of scene.lines) {
    trace(pen, view, line.points);
    pen.lineWidth = Math.max(1, line.width_m * view.scale);
    pen.strokeStyle = line.colour;
    pen.stroke();
  }
  pen.lineCap = 'round';
  for (const wall of scene.walls) {
    trace(pen, view, wall.points);
    pen.lineWidth = Math.max(3, 0.03 * view.scale);
    pen.strokeStyle = shade(wall.colour, -0.15);
    pen.stroke();
  }
  pen.lineWidth = 1.5;
  for (const box of scene.boxes) drawBox(pen, view, box);
  for (const can of scene.cylinders) {
    disc(pen, view.x(can.x_m), view.y(can.y_m), can.radius_m * view.scale);
    pen.fillStyle = can.colour;
    pen.fill();
    pen.strokeStyle = shade(can.colour, -0.3);
    pen.stroke();
  }
}

/** A person from above: shoulders, head, and where the face looks. */
export function drawPerson(pen: Pen, view: RoomView, person: Scene['people'][number]): void {
  const r = Math.max(5, person.radius_m * view.scale);
  pen.save();
  pen.translate(view.x(person.x_m), view.y(person.y_m));
  pen.rotate(-person.heading_deg * turn);
  pen.fillStyle = '#5b6b8c';
  pen.beginPath();
  pen.ellipse(0, 0, r * 0.62, r, 0, 0, 2 * Math.PI);
  pen.fill();
  disc(pen, 0, 0, r * 0.52);
  pen.fillStyle = '#3d2f2a';
  pen.fill();
  pen.fillStyle = '#e9c3a2';
  pen.beginPath();
  pen.arc(r * 0.12, 0, r * 0.44, -1.1, 1.1);
  pen.fill();
  pen.restore();
}

function drawCone(
  pen: Pen,
  view: RoomView,
  pose: Pose,
  hfov_deg: number,
  reach_m: number,
  colour: string,
): void {
  const x = view.x(pose.x_m);
  const y = view.y(pose.y_m);
  const middle = -(pose.heading_deg + pose.pan_deg) * turn;
  const half = (hfov_deg / 2) * turn;
  const radius = reach_m * view.scale;
  const fan = pen.createRadialGradient(x, y, 0, x, y, radius);
  fan.addColorStop(0, veil(colour, 0.3));
  fan.addColorStop(1, veil(colour, 0));
  pen.beginPath();
  pen.moveTo(x, y);
  pen.arc(x, y, radius, middle - half, middle + half);
  pen.closePath();
  pen.fillStyle = fan;
  pen.fill();
}

/** The sonar's answers as points of the room: `blocked` ends the floor, `clear` is at least so far. */
export function sonarPoints(pose: Pose, sonar: Sonar): { point: Point; blocked: boolean }[] {
  return sonar.readings.flatMap(([bearing_deg, answer, distance_m]) => {
    if (distance_m === null || (answer !== 'blocked' && answer !== 'clear')) return [];
    const angle = (pose.heading_deg + bearing_deg) * turn;
    const point: Point = [pose.x_m + distance_m * Math.cos(angle), pose.y_m + distance_m * Math.sin(angle)];
    return [{ point, blocked: answer === 'blocked' }];
  });
}

function drawSonar(pen: Pen, view: RoomView, pose: Pose, sonar: Sonar, colour: string): void {
  const points = sonarPoints(pose, sonar);
  if (points.length === 0) return;
  trace(pen, view, [[pose.x_m, pose.y_m], ...points.map(({ point }) => point)]);
  pen.closePath();
  pen.fillStyle = veil(colour, 0.22);
  pen.fill();
  pen.fillStyle = colour;
  for (const { point, blocked } of points) {
    if (!blocked) continue;
    disc(pen, view.x(point[0]), view.y(point[1]), 2.2);
    pen.fill();
  }
}

function drawBody(pen: Pen, view: RoomView, pose: Pose, robot: Scene['robot']): void {
  pen.save();
  pen.translate(view.x(pose.x_m), view.y(pose.y_m));
  pen.rotate(-pose.heading_deg * turn);
  const s = view.scale;
  pen.beginPath();
  robot.footprint.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x * s, -y * s) : pen.lineTo(x * s, -y * s)));
  pen.closePath();
  pen.lineJoin = 'round';
  pen.lineWidth = 3;
  pen.strokeStyle = robot.contact ? '#e5322d' : '#ffffff';
  pen.fillStyle = '#1f2a44';
  pen.stroke();
  pen.fill();
  pen.rotate(-pose.pan_deg * turn);
  const reach = Math.max(4, 0.06 * s);
  disc(pen, 0, 0, reach * 0.75);
  pen.fillStyle = '#ffffff';
  pen.fill();
  disc(pen, reach * 0.3, 0, reach * 0.38);
  pen.fillStyle = '#0f8f82';
  pen.fill();
  pen.restore();
}

function drawTrail(pen: Pen, view: RoomView, trail: Point[]): void {
  if (trail.length < 2) return;
  trace(pen, view, trail);
  pen.lineWidth = 2;
  pen.lineJoin = 'round';
  pen.strokeStyle = 'rgba(31, 42, 68, 0.35)';
  pen.setLineDash([1, 5]);
  pen.lineCap = 'round';
  pen.stroke();
  pen.setLineDash([]);
}

export interface Actors {
  pose: Pose;
  scene: Scene;
  sonar: Sonar | null;
  trail: Point[];
  hue: string;
}

/** All that moves. */
export function drawActors(pen: Pen, view: RoomView, { pose, scene, sonar, trail, hue }: Actors): void {
  drawTrail(pen, view, trail);
  for (const person of scene.people) drawPerson(pen, view, person);
  drawCone(pen, view, pose, scene.robot.hfov_deg, 1.6, hue);
  if (sonar?.trusted) drawSonar(pen, view, pose, sonar, hue);
  drawBody(pen, view, pose, scene.robot);
}
