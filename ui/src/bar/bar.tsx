import { useComputed } from '@preact/signals';
import { canRedo, canUndo } from '../canvas/canvas';
import { Dialog, openDialog } from '../dialogs/dialog';
import { openSetup } from '../dialogs/setup_dialog';
import { type MessageKey, lang, say, t } from '../messages';
import { type Lang, languages } from '../model/words';
import { editor } from '../state/editor';
import { folded } from '../state/panels';
import {
  link,
  free,
  pause,
  paused,
  release,
  running,
  setup,
  starting,
  stop,
  stopping,
  telemetry,
  seat,
  worlds,
  youDrive,
} from '../state/robot';
import { Eye, FlagIcon, PauseIcon, PlayIcon, StageIcon, StopIcon, UndoIcon } from './icons';
import { Menu, MenuItem } from './menu';
import { ExamplesMenu, ProjectMenu } from './project_menu';

const languageNames: Record<Lang, string> = { en: 'English', es: 'Español' };

function focusStage(): void {
  document.getElementById('stage')?.focus({ preventScroll: true });
}

function Drive() {
  const ready = link.value === 'up' && free.value && editor.value !== null;
  return (
    <div class="drive" role="group" aria-label={t('main_controls')}>
      <button
        type="button"
        class={`round flag ${running.value ? 'on' : ''}`}
        data-testid="flag"
        aria-label={running.value ? t('flag_again') : t('flag')}
        title={running.value ? t('flag_again') : t('flag')}
        disabled={!ready || starting.value}
        onClick={() => {
          editor.value?.flag();
          focusStage();
        }}
      >
        <FlagIcon />
      </button>
      <button
        type="button"
        class={`round pause ${paused.value ? 'on' : ''}`}
        data-testid="pause"
        aria-label={paused.value ? t('resume') : t('pause')}
        title={paused.value ? t('resume') : t('pause')}
        disabled={!ready || !running.value || !youDrive.value}
        onClick={() => {
          pause(!paused.value);
          focusStage();
        }}
      >
        {paused.value ? <PlayIcon /> : <PauseIcon />}
      </button>
      <button type="button" class={`stop ${stopping.value ? 'busy' : ''}`} data-testid="stop" onClick={stop}>
        <StopIcon />
        <span>{stopping.value ? t('stopping') : t('stop')}</span>
      </button>
    </div>
  );
}

function stateWords(): string {
  if (link.value === 'connecting') return t('link_connecting');
  if (link.value === 'lost') return '…';
  const states: Record<string, MessageKey> = {
    running: 'state_running',
    paused: 'state_paused',
    idle: 'state_idle',
  };
  return t(states[telemetry.value?.state ?? 'idle'] ?? 'state_idle');
}

function RobotButton() {
  const words = useComputed(() => (lang.value ? stateWords() : ''));
  const place = useComputed(() => {
    const world = worlds.value.find((choice) => choice.id === setup.value?.world);
    return world ? say(world.name) : (setup.value?.robot ?? '');
  });
  const mood = link.value !== 'up' ? 'off' : running.value ? 'running' : 'ready';
  return (
    <button
      type="button"
      class="button plain robot-button"
      aria-label={t('robot_and_room')}
      onClick={openSetup}
    >
      <i class={`lamp ${mood}`} />
      <span>
        <b>{place}</b>
        <small data-testid="robot-state">{words}</small>
      </span>
    </button>
  );
}

function Driver() {
  if (link.value !== 'up') return null;
  const others = youDrive.value && seat.value.viewers > 1 ? t('viewers', { n: seat.value.viewers - 1 }) : '';
  const who = youDrive.value ? t('you_drive') : free.value ? '' : t('watching');
  if (!who && !others) return null;
  return (
    <span class={youDrive.value ? 'driver' : 'driver watching'} data-testid="driver">
      {who}
      {who && others && ' · '}
      {others}
      {youDrive.value && !running.value && seat.value.viewers > 1 && (
        <button type="button" class="link" onClick={release}>
          {t('give_up')}
        </button>
      )}
    </span>
  );
}

function openHelp(): void {
  openDialog.value = (
    <Dialog title={t('help')}>
      <p>{t('help_text')}</p>
      <p>{t('help_keys')}</p>
    </Dialog>
  );
}

function LanguageMenu() {
  return (
    <Menu
      label={t('language')}
      button={<b data-testid="lang">{lang.value.toUpperCase()} ▾</b>}
      buttonClass="button plain"
    >
      {(close) =>
        languages.map((code) => (
          <MenuItem
            key={code}
            checked={lang.value === code}
            onClick={() => {
              close();
              editor.value?.setLanguage(code);
            }}
          >
            {languageNames[code]}
          </MenuItem>
        ))
      }
    </Menu>
  );
}

function Undo({ redo }: { redo: boolean }) {
  const label = redo ? t('redo') : t('undo');
  return (
    <button
      type="button"
      class="icon-button"
      aria-label={label}
      title={label}
      disabled={!(redo ? canRedo : canUndo).value}
      onClick={() => editor.value?.canvas.undo(redo)}
    >
      <UndoIcon flipped={redo} />
    </button>
  );
}

export function Bar() {
  return (
    <header class="bar">
      <div class="bar-side">
        <span class="brand">
          <Eye />
          <b>Mirada</b>
        </span>
        <ProjectMenu />
        <ExamplesMenu />
        <Undo redo={false} />
        <Undo redo />
      </div>
      <Drive />
      <div class="bar-side right">
        <Driver />
        <RobotButton />
        <LanguageMenu />
        <button type="button" class="icon-button" aria-label={t('help')} title={t('help')} onClick={openHelp}>
          ?
        </button>
        <button
          type="button"
          class="icon-button"
          aria-label={folded.value ? t('unfold_stage') : t('fold_stage')}
          title={folded.value ? t('unfold_stage') : t('fold_stage')}
          aria-pressed={!folded.value}
          data-testid="fold"
          onClick={() => {
            folded.value = !folded.value;
          }}
        >
          <StageIcon />
        </button>
      </div>
    </header>
  );
}
