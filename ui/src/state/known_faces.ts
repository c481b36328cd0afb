/** Whose faces the robot knows, and whether a teacher allows that it learns any. */
import { signal } from '@preact/signals';
import type { Words } from '../model/words';

export interface KnownFaces {
  allowed: boolean;
  people: { name: string; looks: number }[];
}

/** Null until the robot has said it: never to those who may not drive. */
export const knownFaces = signal<KnownFaces | null>(null);

/** What the robot answered to the newest wish, if it refused it. */
export const facesRefused = signal<Words | null>(null);
