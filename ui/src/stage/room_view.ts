/** Where metres of the room lie on the canvas: x to the right, y up. */
import type { Scene } from '../wire/protocol';

export interface RoomView {
  scale: number;
  x(x_m: number): number;
  y(y_m: number): number;
}

const margin_px = 12;

export function fitRoom(bounds: Scene['bounds'], width: number, height: number): RoomView {
  const span_x = Math.max(0.1, bounds.max_x_m - bounds.min_x_m);
  const span_y = Math.max(0.1, bounds.max_y_m - bounds.min_y_m);
  const scale = Math.min((width - 2 * margin_px) / span_x, (height - 2 * margin_px) / span_y);
  const left = (width - span_x * scale) / 2;
  const top = (height - span_y * scale) / 2;
  return {
    scale,
    x: (x_m) => left + (x_m - bounds.min_x_m) * scale,
    y: (y_m) => top + (bounds.max_y_m - y_m) * scale,
  };
}
