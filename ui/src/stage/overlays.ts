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

/** A small label in the colour, kept inside the picture. */
export function drawLabel(pen: Pen, text: string, x: number, y: number, colour: string): void {
  pen.font = '800 13px "Nunito Variable", sans-serif';
  const width = pen.measureText(text).width + 16;
  const { width: w, height: h } = pen.canvas.getBoundingClientRect();
  const left = Math.max(6, Math.min(x - width / 2, w - width - 6));
  const top = Math.max(6, Math.min(y - 34, h - 30));
  pen.beginPath();
  pen.roundRect(left, top, width, 24, 12);
  pen.fillStyle = colour;
  pen.fill();
  pen.fillStyle = '#1f2a44';
  pen.textBaseline = 'middle';
  pen.fillText(text, left + 8, top + 13);
}
