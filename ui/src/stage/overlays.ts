/** What was seen, drawn on the live picture in its pack's hue. */
import type { Answer, Sonar } from '../wire/protocol';

type Pen = CanvasRenderingContext2D;
type Boundary = Sonar['boundary'];

/** Pieces of the boundary with one answer each; a piece ends where columns are missing or the answer changes. */
export function boundaryPieces(boundary: Boundary): { answer: Answer; points: [number, number][] }[] {
  const pieces: { answer: Answer; points: [number, number][] }[] = [];
  const sorted = [...boundary].sort((a, b) => a[0] - b[0]);
  const widest = sorted.length > 1 ? (3 * (sorted.at(-1)![0] - sorted[0]![0])) / (sorted.length - 1) : 0;
  let lastU = -Infinity;
  for (const [u, v, answer] of sorted) {
    const piece = pieces.at(-1);
    if (piece && piece.answer === answer && u - lastU <= widest) piece.points.push([u, v]);
    else pieces.push({ answer, points: [[u, v]] });
    lastU = u;
  }
  return pieces;
}

/** The nearest blocked reading, m; null when nothing blocks. */
export function nearest(sonar: Sonar): number | null {
  const blocked = sonar.readings.filter(([, answer, d]) => answer === 'blocked' && d !== null);
  return blocked.length ? Math.min(...blocked.map(([, , d]) => d!)) : null;
}

/** The place on the picture of what is nearest: the lowest blocked point of the boundary. */
export function nearestPoint(boundary: Boundary): [number, number] | null {
  let best: [number, number] | null = null;
  for (const [u, v, answer] of boundary) if (answer === 'blocked' && (!best || v > best[1])) best = [u, v];
  return best;
}

function stroke(pen: Pen, points: [number, number][], scale: number): void {
  pen.beginPath();
  points.forEach(([u, v], i) => {
    const x = (u + 0.5) * scale;
    const y = (v + 0.5) * scale;
    if (i === 0) pen.moveTo(x - (points.length === 1 ? 2 : 0), y);
    pen.lineTo(x + (points.length === 1 ? 2 : 0), y);
  });
  pen.stroke();
}

export function drawBoundary(pen: Pen, sonar: Sonar, scale: number, colour: string): void {
  pen.lineJoin = 'round';
  pen.lineCap = 'round';
  for (const { answer, points } of boundaryPieces(sonar.boundary)) {
    if (answer !== 'blocked' && answer !== 'clear') continue;
    pen.setLineDash(answer === 'clear' ? [2, 7] : []);
    pen.lineWidth = 5;
    pen.strokeStyle = 'rgba(20, 26, 40, 0.55)';
    stroke(pen, points, scale);
    pen.lineWidth = 3;
    pen.strokeStyle = colour;
    stroke(pen, points, scale);
  }
  pen.setLineDash([]);
}

interface Place {
  left: number;
  top: number;
  width: number;
}

const labelHeight = 24;
const labels = new WeakMap<Pen, Place[]>();

/** A new picture: it has no labels yet. */
export function beginLabels(pen: Pen): void {
  labels.set(pen, []);
}

/** The nearest height, upwards before downwards, at which a label covers none of those that are there. */
export function freeTop(taken: readonly Place[], { left, top, width }: Place, lowest: number): number {
  const covers = (at: number) =>
    taken.some((o) => Math.abs(o.top - at) < labelHeight && o.left < left + width && left < o.left + o.width);
  for (let off = 0; off <= lowest; off += 2) {
    for (const at of [top - off, top + off]) if (at >= 6 && at <= lowest && !covers(at)) return at;
  }
  return top;
}

/** A small label in the colour, kept inside the picture and off the other labels. */
export function drawLabel(pen: Pen, text: string, x: number, y: number, colour: string): void {
  pen.font = '800 13px "Nunito Variable", sans-serif';
  const width = pen.measureText(text).width + 16;
  const { width: w, height: h } = pen.canvas.getBoundingClientRect();
  const left = Math.max(6, Math.min(x - width / 2, w - width - 6));
  const wanted = { left, top: Math.max(6, Math.min(y - 34, h - 30)), width };
  const taken = labels.get(pen) ?? [];
  const top = freeTop(taken, wanted, h - 30);
  taken.push({ left, top, width });
  pen.beginPath();
  pen.roundRect(left, top, width, labelHeight, 12);
  pen.fillStyle = colour;
  pen.fill();
  pen.fillStyle = '#1f2a44';
  pen.textBaseline = 'middle';
  pen.fillText(text, left + 8, top + 13);
}
