import { useComputed, useSignalEffect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { type MessageKey, lang, t } from '../messages';
import { openFaces } from '../dialogs/faces_dialog';
import { editor } from '../state/editor';
import { knownFaces } from '../state/known_faces';
import { panels, togglePanel } from '../state/panels';
import { picture, telemetry } from '../state/robot';
import { drawFaces } from './faces_draw';
import { beginLabels, drawBoundary, drawLabel, nearest, nearestPoint } from './overlays';
import { sharpPen } from './sharp_canvas';

function hueOf(percept: string): string {
  return editor.value?.catalog.hueOf(percept, '#e6a000') ?? '#e6a000';
}

function draw(canvas: HTMLCanvasElement): void {
  const shown = picture.value;
  const now = telemetry.value;
  const ready = sharpPen(canvas);
  if (!ready || !shown) return;
  const { pen, w } = ready;
  const scale = w / shown.header.width;
  beginLabels(pen);
  pen.drawImage(shown.bitmap, 0, 0, w, shown.header.height * scale);
  canvas.dataset.frame = String(shown.header.frame);
  // What was seen before the camera fell silent says nothing about now.
  if (now?.camera_trouble) return;
  if (panels.value.sonar && now?.sonar?.trusted) {
    drawBoundary(pen, now.sonar, scale, hueOf('sonar'));
    const distance = nearest(now.sonar);
    const at = nearestPoint(now.sonar.boundary);
    const words = distance === null ? '' : t('nearest', { cm: Math.round(distance * 100) });
    if (words && at) drawLabel(pen, words, at[0] * scale, at[1] * scale, hueOf('sonar'));
  }
  if (now?.faces && (panels.value.faces || now.faces.lesson))
    drawFaces(pen, now.faces, w / now.faces.width, hueOf('faces'));
}

const troubles: Record<string, MessageKey> = {
  camera_missing: 'camera_missing',
  camera_busy: 'camera_busy',
  camera_lost: 'camera_lost',
  replay_ended: 'camera_replay_ended',
  picture_broken: 'camera_picture_broken',
};

function pictureWords(): string {
  const now = telemetry.value;
  if (now?.camera_trouble) return t(troubles[now.camera_trouble] ?? 'camera_lost');
  if (!picture.value) return t('no_picture');
  return panels.value.sonar && now?.sonar && !now.sonar.trusted ? t('not_trusted') : '';
}

export function Picture() {
  const ref = useRef<HTMLCanvasElement>(null);
  const words = useComputed(() => (lang.value ? pictureWords() : ''));
  const ratio = useComputed(() =>
    picture.value ? picture.value.header.width / picture.value.header.height : 4 / 3,
  );
  const plainFaces = useComputed(() => telemetry.value?.faces?.detector === 'haar');
  useSignalEffect(() => {
    if (ref.current) draw(ref.current);
  });
  return (
    <section class="card picture-card" aria-label={t('sees')}>
      <header class="card-head">
        <h2>{t('sees')}</h2>
        <button
          type="button"
          class="chip"
          aria-pressed={panels.value.sonar}
          style={{ '--hue': hueOf('sonar') }}
          onClick={() => togglePanel('sonar')}
        >
          {t('show_boundary')}
        </button>
        <button
          type="button"
          class="chip"
          aria-pressed={panels.value.faces}
          style={{ '--hue': hueOf('faces') }}
          title={plainFaces.value ? t('faces_plain') : undefined}
          onClick={() => togglePanel('faces')}
        >
          {plainFaces.value ? t('show_faces_plain') : t('show_faces')}
        </button>
        {knownFaces.value && (
          <button
            type="button"
            class="chip opens"
            data-testid="known-faces"
            title={t('faces_known')}
            onClick={openFaces}
          >
            {t('faces_names')}
          </button>
        )}
      </header>
      <div
        class={telemetry.value?.camera_trouble ? 'picture-frame stale' : 'picture-frame'}
        style={{ aspectRatio: String(ratio.value) }}
      >
        <canvas ref={ref} class="picture" data-testid="picture" role="img" aria-label={t('sees')} />
        {words.value && <p class="over-picture">{words.value}</p>}
      </div>
    </section>
  );
}
