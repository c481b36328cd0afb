/** Faces on the live picture: box, who, how far, where they came from, and what following does. */
import { type MessageKey, say, t } from '../messages';
import type { Face, Faces, Lesson } from '../wire/protocol';
import { drawLabel } from './overlays';

type Pen = CanvasRenderingContext2D;
type Trail = { frame: number; points: [number, number][] };

const longest = 24;
const trails = new Map<number, Trail>();

/** Notes where the faces of this picture are; a picture that is drawn again adds nothing. */
export function noteTrails(faces: Faces, known: Map<number, Trail> = trails): void {
  for (const face of faces.faces) {
    const trail = known.get(face.id) ?? { frame: -1, points: [] };
    if (trail.frame === faces.frame) continue;
    trail.frame = faces.frame;
    trail.points.push([face.x + face.w / 2, face.y + face.h / 2]);
    if (trail.points.length > longest) trail.points.shift();
    known.set(face.id, trail);
  }
  const shown = new Set([...faces.faces, ...faces.bodies].map((face) => face.id));
  for (const id of known.keys()) if (!shown.has(id)) known.delete(id);
}

const states: Record<string, MessageKey> = {
  following: 'follow_following',
  predicted: 'follow_predicted',
  searching: 'follow_searching',
  gone: 'follow_gone',
};

/** "Ana · 1.2 m · following", or with the number when the name is not known. */
export function faceWords(face: Face, follow: Faces['follow']): string {
  const parts = [face.name || `${face.id}`];
  if (face.distance_m > 0) parts.push(t('metres_away', { m: face.distance_m.toFixed(1) }));
  const state = states[follow.state];
  if (state && follow.id === face.id) parts.push(t(state));
  return parts.join(' · ');
}

/** "Ana: 3 of 8. Come a little closer." */
export function lessonWords(lesson: Lesson): string {
  const progress = t('faces_lesson', { name: lesson.name, looks: lesson.looks, needed: lesson.needed });
  return lesson.hint ? `${progress} ${say(lesson.hint)}` : progress;
}

function box(pen: Pen, face: Face, scale: number, colour: string): void {
  pen.beginPath();
  pen.roundRect(face.x * scale, face.y * scale, face.w * scale, face.h * scale, 10);
  pen.setLineDash(face.predicted ? [6, 6] : []);
  pen.lineWidth = 5;
  pen.strokeStyle = 'rgba(20, 26, 40, 0.55)';
  pen.stroke();
  pen.lineWidth = 3;
  pen.strokeStyle = colour;
  pen.stroke();
  pen.setLineDash([]);
}

function trail(pen: Pen, points: [number, number][], scale: number, colour: string): void {
  if (points.length < 2) return;
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(x * scale, y * scale);
  pen.lineWidth = 2;
  pen.globalAlpha = 0.7;
  pen.strokeStyle = colour;
  pen.stroke();
  pen.globalAlpha = 1;
}

export function drawFaces(pen: Pen, faces: Faces, scale: number, colour: string): void {
  noteTrails(faces);
  for (const face of [...faces.bodies, ...faces.faces]) {
    trail(pen, trails.get(face.id)?.points ?? [], scale, colour);
    box(pen, face, scale, colour);
    if (face.id > 0)
      drawLabel(pen, faceWords(face, faces.follow), (face.x + face.w / 2) * scale, face.y * scale, colour);
  }
  if (faces.lesson)
    drawLabel(pen, lessonWords(faces.lesson), pen.canvas.getBoundingClientRect().width / 2, 80, colour);
  const { state, id } = faces.follow;
  const words = states[state];
  if (words && ![...faces.bodies, ...faces.faces].some((face) => face.id === id))
    drawLabel(pen, t(words), pen.canvas.getBoundingClientRect().width / 2, 44, colour);
}
