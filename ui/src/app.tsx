import { useComputed, useSignal, useSignalEffect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { Bar } from './bar/bar';
import { openCalibrate } from './dialogs/calibrate_dialog';
import { DialogHost, openDialog } from './dialogs/dialog';
import { t } from './messages';
import { Above } from './stage/above';
import { Picture } from './stage/picture';
import { Readings } from './stage/readings';
import { calibration, leaving } from './state/calibration';
import { editor } from './state/editor';
import { folded } from './state/panels';
import { link, notes, youDrive } from './state/robot';

function Search() {
  const query = useSignal('');
  const show = (text: string) => {
    query.value = text;
    editor.value?.canvas.search(text);
  };
  return (
    <div class="search">
      <input
        type="search"
        value={query.value}
        placeholder={t('search')}
        aria-label={t('search')}
        onInput={(event) => show(event.currentTarget.value)}
        onFocus={(event) => event.currentTarget.value && show(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === 'Escape') show('');
        }}
      />
    </div>
  );
}

function Banner() {
  if (link.value !== 'lost') return null;
  return (
    <div class="banner" role="alert" data-testid="banner">
      <i class="spinner" />
      {t('link_lost')}
    </div>
  );
}

function StatusLine() {
  const last = useComputed(() => notes.value.at(-1));
  return (
    <footer class={`status ${last.value?.severity ?? 'info'}`} role="status" data-testid="status">
      {last.value?.words() ?? ''}
    </footer>
  );
}

/** The page; `mount` gets the element that the canvas lives in, once. */
export function App({ mount }: { mount: (element: HTMLElement) => void }) {
  const canvas = useRef<HTMLDivElement>(null);
  useEffect(() => {
    mount(canvas.current!);
    const observer = new ResizeObserver(() => editor.peek()?.canvas.resize());
    observer.observe(canvas.current!);
    return () => observer.disconnect();
  }, []);
  // A page that was reloaded in the middle of a calibration goes on with it.
  useSignalEffect(() => {
    const begun = calibration.value?.phase === 'looking' || calibration.value?.phase === 'ready';
    if (begun && youDrive.value && !leaving.value && !openDialog.peek()) openCalibrate();
  });
  return (
    <div class={folded.value ? 'page folded' : 'page'}>
      <Bar />
      <Banner />
      <main class="work">
        <div class="canvas-side">
          <Search />
          <div ref={canvas} class="canvas" aria-label={t('canvas')} />
        </div>
        <aside id="stage" class="stage" tabIndex={-1}>
          <Picture />
          <Above />
          <Readings />
        </aside>
      </main>
      <StatusLine />
      <DialogHost />
    </div>
  );
}
