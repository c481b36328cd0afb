import { useSignalEffect } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import { say, t } from '../messages';
import { boardSvg } from '../model/board_svg';
import { drawCalibration } from '../stage/calibration_draw';
import { sharpPen } from '../stage/sharp_canvas';
import {
  type BoardPlan,
  boardSize,
  calibration,
  cameras,
  keepPlan,
  keptPlan,
  leaving,
  wizardOpen,
} from '../state/calibration';
import { free, picture, send, setup } from '../state/robot';
import type { CalibrationState } from '../wire/protocol';
import { Dialog, closeDialog, openDialog } from './dialog';

type Action = 'take' | 'finish' | 'save' | 'cancel';
const step = (action: Action) => send({ type: 'calibrate', action });

/** Opens a page of its own with the board, and the browser's way to print it. */
function printBoard(plan: BoardPlan): void {
  const size = boardSize(plan.size);
  if (!size) return;
  const [across, down] = plan.board === 'charuco' ? [size[0] - 1, size[1] - 1] : size;
  const url = URL.createObjectURL(
    new Blob([boardSvg(across, down, plan.square_mm)], { type: 'image/svg+xml' }),
  );
  window.open(url, '_blank');
  window.setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

function CameraChoice({ chosen, choose }: { chosen: string; choose: (id: string) => void }) {
  return (
    <label class="label">
      {t('cal_camera')}
      <select
        class="text-input"
        value={chosen}
        data-testid="cal-camera"
        onChange={(event) => choose(event.currentTarget.value)}
      >
        <option value="">{t('cal_camera_unknown')}</option>
        {cameras.value.map((camera) => (
          <option key={camera.id} value={camera.id}>
            {say(camera.name)}
          </option>
        ))}
      </select>
    </label>
  );
}

function BoardFields({ plan, change }: { plan: BoardPlan; change: (next: BoardPlan) => void }) {
  return (
    <>
      <fieldset class="choices">
        <legend>{t('cal_board')}</legend>
        {(['chessboard', 'charuco'] as const).map((board) => (
          <label key={board} class="choice">
            <input
              type="radio"
              name="board"
              checked={plan.board === board}
              onChange={() => change({ ...plan, board, size: board === 'charuco' ? '7x5' : '9x6' })}
            />
            <span>{t(board === 'charuco' ? 'cal_charuco' : 'cal_chessboard')}</span>
          </label>
        ))}
      </fieldset>
      <div class="cal-fields">
        <label class="label">
          {t(plan.board === 'charuco' ? 'cal_squares' : 'cal_corners')}
          <input
            class="text-input"
            value={plan.size}
            data-testid="cal-size"
            onInput={(event) => change({ ...plan, size: event.currentTarget.value })}
          />
        </label>
        <label class="label">
          {t('cal_square_mm')}
          <input
            class="text-input"
            type="number"
            min={1}
            max={1000}
            step="any"
            value={plan.square_mm}
            data-testid="cal-square"
            onInput={(event) => change({ ...plan, square_mm: Number(event.currentTarget.value) })}
          />
        </label>
      </div>
      <CameraChoice chosen={plan.camera} choose={(camera) => change({ ...plan, camera })} />
    </>
  );
}

function Start() {
  const [plan, setPlan] = useState(keptPlan);
  const fits = boardSize(plan.size) !== null && plan.square_mm > 0;
  const begin = (event: Event) => {
    event.preventDefault();
    if (!fits) return;
    keepPlan(plan);
    send({ type: 'calibrate', action: 'begin', ...plan, size: boardSize(plan.size)!.join('x') });
  };
  return (
    <form onSubmit={begin}>
      <p>{t('cal_why')}</p>
      <BoardFields plan={plan} change={setPlan} />
      <p class="quiet">{t(setup.value?.simulated ? 'cal_simulated' : 'cal_flat')}</p>
      {!fits && <p class="field-fault">{t('cal_size_wrong')}</p>}
      {!free.value && <p class="field-fault">{t('watching')}</p>}
      <footer>
        {plan.board === 'chessboard' && (
          <button type="button" class="button" disabled={!fits} onClick={() => printBoard(plan)}>
            {t('cal_print')}
          </button>
        )}
        <button
          type="submit"
          class="button primary"
          data-first
          data-testid="cal-begin"
          disabled={!fits || !free.value}
        >
          {t('cal_begin')}
        </button>
      </footer>
    </form>
  );
}

function draw(canvas: HTMLCanvasElement): void {
  const shown = picture.value;
  const state = calibration.value;
  const ready = sharpPen(canvas);
  if (!ready || !shown) return;
  const { pen, w } = ready;
  const scale = w / shown.header.width;
  pen.drawImage(shown.bitmap, 0, 0, w, shown.header.height * scale);
  if (state && state.width > 0) drawCalibration(pen, state, w / state.width);
}

function LivePicture({ state }: { state: CalibrationState }) {
  const ref = useRef<HTMLCanvasElement>(null);
  useSignalEffect(() => {
    if (ref.current) draw(ref.current);
  });
  const ratio = state.width > 0 ? state.width / state.height : 4 / 3;
  return (
    <div class="cal-picture" style={{ aspectRatio: String(ratio) }}>
      <canvas ref={ref} role="img" aria-label={t('sees')} data-testid="cal-picture" />
      {!picture.value && <p class="over-picture">{t('no_picture')}</p>}
    </div>
  );
}

function Meter({ label, share, words }: { label: string; share: number; words: string }) {
  return (
    <div class="cal-meter">
      <span>{label}</span>
      <div role="progressbar" aria-label={label} aria-valuenow={Math.round(100 * Math.min(1, share))}>
        <i style={{ width: `${100 * Math.min(1, share)}%` }} />
      </div>
      <b>{words}</b>
    </div>
  );
}

function Looking({ state }: { state: CalibrationState }) {
  const working = state.phase === 'working';
  return (
    <>
      <p class="cal-next" role="status" data-testid="cal-next">
        {working ? say(state.now ?? undefined) : say(state.next ?? undefined)}
      </p>
      <LivePicture state={state} />
      <p class="cal-now quiet" data-testid="cal-now">
        {working ? '' : say(state.now ?? undefined)}
      </p>
      <Meter
        label={t('cal_pictures')}
        share={state.views / Math.max(1, state.views_good)}
        words={`${state.views} / ${state.views_good}`}
      />
      <Meter
        label={t('cal_covered')}
        share={state.coverage / 0.5}
        words={`${Math.round(100 * state.coverage)} %`}
      />
      <Meter label={t('cal_tilted')} share={state.tilt_deg / 25} words={`${Math.round(state.tilt_deg)}°`} />
      {state.room_holds && <p class="quiet">{t('cal_room_holds')}</p>}
      <footer>
        <button type="button" class="button" onClick={closeWizard} data-testid="cal-cancel">
          {t('cancel')}
        </button>
        <button
          type="button"
          class="button"
          disabled={working}
          onClick={() => step('take')}
          data-testid="cal-take"
        >
          {t('cal_take')}
        </button>
        <button
          type="button"
          class="button primary"
          disabled={working || state.views < state.views_needed}
          onClick={() => step('finish')}
          data-testid="cal-finish"
        >
          {t('cal_finish')}
        </button>
      </footer>
    </>
  );
}

function ResultButtons({ state }: { state: CalibrationState }) {
  if (state.phase === 'saved') {
    return (
      <button type="button" class="button primary" onClick={closeWizard} data-testid="cal-close">
        {t('close')}
      </button>
    );
  }
  return (
    <>
      <button type="button" class="button" onClick={closeWizard} data-testid="cal-cancel">
        {t('cancel')}
      </button>
      {state.phase === 'poor' ? (
        <button type="button" class="button primary" onClick={() => step('take')} data-testid="cal-more">
          {t('cal_more')}
        </button>
      ) : (
        <button type="button" class="button primary" onClick={() => step('save')} data-testid="cal-save">
          {t('cal_save')}
        </button>
      )}
    </>
  );
}

function Result({ state }: { state: CalibrationState }) {
  return (
    <>
      <LivePicture state={state} />
      <ul class={`cal-words ${state.phase}`} role="status" data-testid="cal-words">
        {state.words.map((fault, i) => (
          <li key={i} class={fault.severity}>
            {/^\d+$/.test(fault.place) && <b>{t('cal_picture_n', { n: fault.place })} </b>}
            {say(fault.message)}
          </li>
        ))}
      </ul>
      <footer>
        <ResultButtons state={state} />
      </footer>
    </>
  );
}

function Body() {
  const state = calibration.value;
  if (!state || state.phase === 'off' || leaving.value) return <Start />;
  if (state.phase === 'looking' || state.phase === 'working') return <Looking state={state} />;
  return <Result state={state} />;
}

function CalibrateDialog() {
  useEffect(() => {
    wizardOpen.value = true;
    return () => {
      wizardOpen.value = false;
    };
  }, []);
  return (
    <Dialog title={t('cal_title')} wide firm onClose={leave}>
      <div data-testid="calibrate">
        <Body />
      </div>
    </Dialog>
  );
}

/** Leaves the robot without a wizard: nothing that was not saved is kept. */
function leave(): void {
  if (!calibration.peek() || calibration.peek()!.phase === 'off') return;
  leaving.value = true;
  step('cancel');
}

function closeWizard(): void {
  closeDialog();
  leave();
}

/** Opens the wizard; it goes on where the robot is. */
export function openCalibrate(): void {
  openDialog.value = <CalibrateDialog />;
}
