import { useState } from 'preact/hooks';
import { say, t } from '../messages';
import { choose, free, putBack, robots, setup, worlds } from '../state/robot';
import type { Choice } from '../wire/protocol';
import { openCalibrate } from './calibrate_dialog';
import { Dialog, closeDialog, openDialog } from './dialog';

function Choices(props: { label: string; all: Choice[]; chosen: string; choose: (id: string) => void }) {
  return (
    <fieldset class="choices">
      <legend>{props.label}</legend>
      {props.all.map((choice) => (
        <label key={choice.id} class="choice">
          <input
            type="radio"
            name={props.label}
            value={choice.id}
            checked={choice.id === props.chosen}
            onChange={() => props.choose(choice.id)}
          />
          <span>{say(choice.name)}</span>
        </label>
      ))}
    </fieldset>
  );
}

const largestSeed = 2 ** 31;

function SetupDialog() {
  const now = setup.value;
  const [next, setNext] = useState({
    world: now?.world ?? '',
    robot: now?.robot ?? '',
    seed: now?.seed ?? 1,
  });
  const seedOk = Number.isInteger(next.seed) && next.seed >= 0 && next.seed <= largestSeed;
  const submit = (event: Event) => {
    event.preventDefault();
    if (!seedOk) return;
    if (choose(next)) closeDialog();
  };
  const newSeed = () => setNext({ ...next, seed: 1 + Math.floor(Math.random() * 99_999) });
  return (
    <Dialog title={t('robot_and_room')} wide>
      <form onSubmit={submit}>
        {worlds.value.length > 0 && (
          <Choices
            label={t('room')}
            all={worlds.value}
            chosen={next.world}
            choose={(world) => setNext({ ...next, world })}
          />
        )}
        <Choices
          label={t('robot')}
          all={robots.value}
          chosen={next.robot}
          choose={(robot) => setNext({ ...next, robot })}
        />
        {now?.simulated && (
          <div class="seed">
            <label class="label">
              {t('seed')}
              <input
                class="text-input"
                type="number"
                min={0}
                max={largestSeed}
                value={next.seed}
                onInput={(event) => setNext({ ...next, seed: Number(event.currentTarget.value) })}
              />
            </label>
            <button type="button" class="button" onClick={newSeed}>
              {t('new_seed')}
            </button>
            {seedOk ? (
              <p class="quiet">{t('seed_hint')}</p>
            ) : (
              <p class="field-fault" role="alert">
                {t('seed_range', { max: largestSeed })}
              </p>
            )}
          </div>
        )}
        {!free.value && <p class="field-fault">{t('watching')}</p>}
        <footer>
          <button type="button" class="button" data-testid="calibrate-open" onClick={openCalibrate}>
            {t('cal_open')}
          </button>
          <button
            type="button"
            class="button"
            disabled={!free.value}
            onClick={() => {
              putBack();
              closeDialog();
            }}
          >
            ↺ {t('put_back')}
          </button>
          <button type="submit" class="button primary" data-first disabled={!free.value || !seedOk}>
            {t('use_it')}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}

/** Opens the choice of room, robot and seed. */
export function openSetup(): void {
  openDialog.value = <SetupDialog />;
}
