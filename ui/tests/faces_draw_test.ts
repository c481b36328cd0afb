import { expect, test } from 'vitest';
import { faceWords, lessonWords, noteTrails } from '../src/stage/faces_draw';
import type { Face, Faces } from '../src/wire/protocol';

const face = (id: number, x: number, extra: Partial<Face> = {}): Face => ({
  id,
  x,
  y: 20,
  w: 30,
  h: 40,
  score: 0.9,
  bearing_deg: 0,
  distance_m: 1.24,
  sigma_m: 0.1,
  predicted: false,
  name: '',
  who: 'unsure',
  ...extra,
});
const seen = (frame: number, faces: Face[], bodies: Face[] = []): Faces => ({
  frame,
  t_us: 0,
  width: 320,
  height: 240,
  detector: 'ultraface',
  faces,
  bodies,
  follow: { state: '', id: 0 },
  lesson: null,
});

test('a trail grows with each picture, not with each drawing, and ends when the face has gone', () => {
  const trails = new Map<number, { frame: number; points: [number, number][] }>();
  noteTrails(seen(1, [face(1, 10)]), trails);
  noteTrails(seen(1, [face(1, 10)]), trails);
  noteTrails(seen(2, [face(1, 20), face(2, 90)]), trails);
  expect(trails.get(1)!.points).toEqual([
    [25, 40],
    [35, 40],
  ]);
  noteTrails(seen(3, [face(2, 95)], [face(1, 30)]), trails);
  expect(trails.get(1)!.points).toHaveLength(2);
  noteTrails(seen(4, [face(2, 95)]), trails);
  expect([...trails.keys()]).toEqual([2]);
});

test('a face says who it is, how far away, and what following does with it', () => {
  expect(faceWords(face(3, 0), { state: '', id: 0 })).toBe('3 · 1.2 m');
  expect(faceWords(face(3, 0, { name: 'Ana' }), { state: 'predicted', id: 3 })).toBe(
    'Ana · 1.2 m · going by where they went',
  );
  expect(faceWords(face(3, 0), { state: 'following', id: 4 })).toBe('3 · 1.2 m');
});

test('a lesson says how far it is and what to do', () => {
  const hint = { en: 'Look at me.', es: 'Mírame.' };
  expect(lessonWords({ name: 'Ana', looks: 3, needed: 8, hint })).toBe('Ana: 3 of 8. Look at me.');
  expect(lessonWords({ name: 'Ana', looks: 3, needed: 8, hint: null })).toBe('Ana: 3 of 8.');
});
