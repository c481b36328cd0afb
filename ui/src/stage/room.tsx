import { useComputed } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { t } from '../messages';
import { editor } from '../state/editor';
import { free, putBack, setup, telemetry } from '../state/robot';
import type { Point, Scene } from '../wire/protocol';
import { MotionTrack, type Pose } from './motion_track';
import { drawActors, drawRoom } from './room_draw';
import { type RoomView, fitRoom } from './room_view';
import { sharpPen } from './sharp_canvas';

const trailStep_m = 0.03;
const trailLength = 600;

/** Draws the room as long as something moves in it; the still part is kept as a picture of its own. */
class RoomPainter {
  private readonly track = new MotionTrack();
  private readonly still = document.createElement('canvas');
  private stillKey = '';
  private trail: Point[] = [];
  private run = -1;
  private scheduled = 0;
  private stopped = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly bubble: HTMLElement,
  ) {}

  /** New telemetry, or the place on the page has changed. */
  update(): void {
    const now = telemetry.peek();
    if (now?.scene) {
      const { robot } = now.scene;
      this.track.push(now.t_us, robot, performance.now());
      if (now.run !== this.run) this.trail = [];
      this.run = now.run;
      this.addToTrail(robot);
    }
    this.wake();
  }

  dispose(): void {
    this.stopped = true;
    cancelAnimationFrame(this.scheduled);
  }

  private wake(): void {
    if (this.scheduled || this.stopped) return;
    this.scheduled = requestAnimationFrame(() => {
      this.scheduled = 0;
      this.paint();
      if (!this.track.settled(performance.now())) this.wake();
    });
  }

  private addToTrail(pose: Pose): void {
    const last = this.trail.at(-1);
    const far = last ? Math.hypot(pose.x_m - last[0], pose.y_m - last[1]) : Infinity;
    if (far > 0.6) this.trail = [];
    if (far < trailStep_m) return;
    this.trail.push([pose.x_m, pose.y_m]);
    if (this.trail.length > trailLength) this.trail.shift();
  }

  private paint(): void {
    const ready = sharpPen(this.canvas);
    const now = telemetry.peek();
    const pose = this.track.at(performance.now());
    if (!ready || !now?.scene || !pose) return;
    const { pen, w, h } = ready;
    const view = fitRoom(now.scene.bounds, w, h);
    this.refreshStill(now.scene, view, w, h);
    pen.clearRect(0, 0, w, h);
    pen.drawImage(this.still, 0, 0, w, h);
    const hue = editor.peek()?.catalog.hueOf('sonar', '#e6a000') ?? '#e6a000';
    drawActors(pen, view, { pose, scene: now.scene, sonar: now.sonar, trail: this.trail, hue });
    this.placeBubble(view, pose, w);
    this.canvas.dataset.pose = [pose.x_m, pose.y_m, pose.heading_deg].map((n) => n.toFixed(3)).join(' ');
  }

  private refreshStill(scene: Scene, view: RoomView, w: number, h: number): void {
    const { bounds, floor_colour, lines, walls, boxes, cylinders } = scene;
    const ratio = window.devicePixelRatio || 1;
    const key = JSON.stringify([w, h, ratio, bounds, floor_colour, lines, walls, boxes, cylinders]);
    if (key === this.stillKey) return;
    this.stillKey = key;
    this.still.width = Math.round(w * ratio);
    this.still.height = Math.round(h * ratio);
    const pen = this.still.getContext('2d');
    if (!pen) return;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawRoom(pen, view, scene);
  }

  private placeBubble(view: RoomView, pose: Pose, w: number): void {
    const half = this.bubble.offsetWidth / 2;
    const x = Math.max(half + 4, Math.min(view.x(pose.x_m), w - half - 4));
    this.bubble.style.left = `${x}px`;
    this.bubble.style.top = `${Math.max(this.bubble.offsetHeight + 4, view.y(pose.y_m) - 16)}px`;
  }
}

export function Room({ tabs }: { tabs: ComponentChildren }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const bubble = useRef<HTMLDivElement>(null);
  const say = useComputed(() => telemetry.value?.say ?? '');
  const summary = useComputed(() => {
    const scene = telemetry.value?.scene;
    return scene ? t('contacts_path', { n: scene.contacts, m: scene.path_m.toFixed(1) }) : '';
  });
  const touching = useComputed(() => telemetry.value?.scene?.robot.contact ?? false);
  const bare = useComputed(() => setup.value?.simulated === false && telemetry.value?.scene === null);
  useEffect(() => {
    const painter = new RoomPainter(canvas.current!, bubble.current!);
    const unsubscribe = telemetry.subscribe(() => painter.update());
    const observer = new ResizeObserver(() => painter.update());
    observer.observe(canvas.current!);
    return () => {
      unsubscribe();
      observer.disconnect();
      painter.dispose();
    };
  }, []);
  return (
    <section class="card room-card" aria-label={t('room_above')}>
      <header class="card-head">
        {tabs}
        <button type="button" class="button small" disabled={!free.value} onClick={putBack}>
          ↺ {t('put_back')}
        </button>
      </header>
      <div class="room-frame">
        <canvas ref={canvas} class="room" data-testid="room" role="img" aria-label={t('room_above')} />
        <div ref={bubble} class="say-bubble" hidden={!say.value} role="status">
          <span>{say}</span>
        </div>
        <span class={touching.value ? 'summary touching' : 'summary'}>
          {touching.value ? t('contact') : summary}
        </span>
        {bare.value && <p class="over-picture">{t('no_scene')}</p>}
      </div>
    </section>
  );
}
