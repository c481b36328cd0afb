/** The wizard's picture: where the board has been, where it is, and where it should go next. */
import type { CalibrationState, Point } from '../wire/protocol';

type Pen = CanvasRenderingContext2D;

const been = 'rgba(15, 143, 130, 0.28)';
const here = '#ffd54a';
const wanted = '#ff7a1a';

function trace(pen: Pen, points: Point[], scale: number, closed: boolean): void {
  pen.beginPath();
  points.forEach(([u, v], i) => {
    const x = (u + 0.5) * scale;
    const y = (v + 0.5) * scale;
    if (i === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  });
  if (closed) pen.closePath();
}

function dots(pen: Pen, points: Point[], scale: number): void {
  pen.fillStyle = here;
  pen.strokeStyle = 'rgba(20, 26, 40, 0.6)';
  pen.lineWidth = 1;
  for (const [u, v] of points) {
    pen.beginPath();
    pen.arc((u + 0.5) * scale, (v + 0.5) * scale, 3, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  }
}

/** `scale`: page pixels to one of the camera's. */
export function drawCalibration(pen: Pen, state: CalibrationState, scale: number): void {
  for (const outline of state.taken) {
    trace(pen, outline, scale, true);
    pen.fillStyle = been;
    pen.fill();
  }
  if (state.phase !== 'looking') return;
  if (state.target.length > 2) {
    trace(pen, state.target, scale, true);
    pen.lineJoin = 'round';
    pen.setLineDash([10, 7]);
    pen.lineWidth = 5;
    pen.strokeStyle = 'rgba(20, 26, 40, 0.5)';
    pen.stroke();
    pen.lineWidth = 3;
    pen.strokeStyle = wanted;
    pen.stroke();
    pen.setLineDash([]);
  }
  dots(pen, state.corners, scale);
}
