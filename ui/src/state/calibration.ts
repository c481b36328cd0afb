/** What the calibration wizard knows: the robot's newest word on it, and the board that was told last. */
import { signal } from '@preact/signals';
import type { CalibrationState, Choice } from '../wire/protocol';

export const calibration = signal<CalibrationState | null>(null);
/** The wizard was closed here, and the robot has not yet said that it ended. */
export const leaving = signal(false);
/** Cameras whose datasheets the robot knows. */
export const cameras = signal<Choice[]>([]);
/** The wizard is on the page: pictures are wanted even if the stage is folded away. */
export const wizardOpen = signal(false);

export interface BoardPlan {
  board: 'chessboard' | 'charuco';
  size: string;
  square_mm: number;
  camera: string;
}

const key = 'mirada.board';

export function keptPlan(): BoardPlan {
  const first: BoardPlan = { board: 'chessboard', size: '9x6', square_mm: 25, camera: '' };
  try {
    return { ...first, ...(JSON.parse(localStorage.getItem(key) ?? '{}') as object) };
  } catch {
    return first;
  }
}

export function keepPlan(plan: BoardPlan): void {
  localStorage.setItem(key, JSON.stringify(plan));
}

/** "9x6" as two numbers; null when it is no such size. */
export function boardSize(text: string): [columns: number, rows: number] | null {
  const match = /^\s*(\d{1,2})\s*[x×]\s*(\d{1,2})\s*$/i.exec(text);
  if (!match) return null;
  const [columns, rows] = [Number(match[1]), Number(match[2])];
  const fits = (n: number) => n >= 3 && n <= 60;
  return fits(columns) && fits(rows) ? [columns, rows] : null;
}
