import { useComputed } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { t } from '../messages';
import { editor } from '../state/editor';
import { telemetry } from '../state/robot';
import type { Memory as Remembered } from '../wire/protocol';
import { drawMemory, memoryView } from './memory_draw';
import { sharpPen } from './sharp_canvas';

const whys = {
  old: 'why_old',
  never_seen: 'why_never_seen',
  on_the_way: 'why_on_the_way',
  its_turn: 'why_its_turn',
  the_face: 'why_the_face',
} as const;

/** What attention does next, in words. */
export function attentionWords(memory: Remembered | null): string {
  if (!memory) return '';
  const why = whys[memory.next.why as keyof typeof whys];
  return why ? t(why) : t('remembers', { n: memory.places.length });
}

function paint(canvas: HTMLCanvasElement): void {
  const ready = sharpPen(canvas);
  if (!ready) return;
  const { pen, w, h } = ready;
  pen.clearRect(0, 0, w, h);
  const memory = telemetry.peek()?.memory;
  if (!memory) return;
  const packs = editor.peek()?.catalog.packs ?? [];
  const hue = packs.find((pack) => pack.id === 'memory')?.colour ?? '#9966ff';
  drawMemory(pen, memoryView(w, h, memory), memory, hue);
  canvas.dataset.places = String(memory.places.length);
}

export function Memory({ tabs }: { tabs: ComponentChildren }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const words = useComputed(() => attentionWords(telemetry.value?.memory ?? null));
  useEffect(() => {
    const update = () => canvas.current && paint(canvas.current);
    const unsubscribe = telemetry.subscribe(update);
    const observer = new ResizeObserver(update);
    observer.observe(canvas.current!);
    return () => {
      unsubscribe();
      observer.disconnect();
    };
  }, []);
  return (
    <section class="card room-card" aria-label={t('memory_above')}>
      <header class="card-head">{tabs}</header>
      <div class="room-frame">
        <canvas ref={canvas} class="room" data-testid="memory" role="img" aria-label={t('memory_above')} />
        <span class="summary">{words.value}</span>
      </div>
    </section>
  );
}
