import { useState } from 'preact/hooks';
import { say, t } from '../messages';
import { facesRefused, knownFaces } from '../state/known_faces';
import { send } from '../state/robot';
import { Dialog, openDialog } from './dialog';

/** The switch that a teacher turns on with a code; off needs none. */
function Allow({ allowed }: { allowed: boolean }) {
  const [code, setCode] = useState('');
  const turn = (event: Event) => {
    event.preventDefault();
    facesRefused.value = null;
    send({ type: 'faces', action: 'allow', on: !allowed, code });
    setCode('');
  };
  return (
    <form onSubmit={turn} class="faces-allow">
      <p data-testid="faces-state">{allowed ? t('faces_on') : t('faces_off')}</p>
      {!allowed && (
        <label class="label">
          {t('faces_code')}
          <input
            class="text-input"
            data-testid="faces-code"
            autocomplete="off"
            maxLength={20}
            value={code}
            onInput={(event) => setCode(event.currentTarget.value)}
          />
        </label>
      )}
      <button
        type="submit"
        role="switch"
        aria-checked={allowed}
        class={allowed ? 'button' : 'button primary'}
        data-testid="faces-allow"
        disabled={!allowed && !code.trim()}
      >
        {allowed ? t('faces_forbid') : t('faces_allow')}
      </button>
    </form>
  );
}

function Person({ name, looks }: { name: string; looks: number }) {
  const [next, setNext] = useState(name);
  const to = next.trim();
  const rename = (event: Event) => {
    event.preventDefault();
    facesRefused.value = null;
    if (to && to !== name) send({ type: 'faces', action: 'rename', name, to });
  };
  return (
    <li class="faces-person">
      <form onSubmit={rename}>
        <input
          class="text-input"
          aria-label={t('faces_name_of', { name })}
          maxLength={40}
          value={next}
          onInput={(event) => setNext(event.currentTarget.value)}
        />
        <small>{t('faces_looks', { n: looks })}</small>
        <button type="submit" class="button" disabled={!to || to === name}>
          {t('faces_rename')}
        </button>
        <button
          type="button"
          class="button"
          aria-label={t('faces_forget_name', { name })}
          onClick={() => {
            facesRefused.value = null;
            send({ type: 'faces', action: 'forget', name });
          }}
        >
          {t('faces_forget')}
        </button>
      </form>
    </li>
  );
}

function FacesDialog() {
  const known = knownFaces.value;
  return (
    <Dialog title={t('faces_known')} wide onClose={() => (facesRefused.value = null)}>
      <p class="quiet">{t('faces_privacy')}</p>
      {known && <Allow allowed={known.allowed} />}
      <p class="field-fault" role="alert" data-testid="faces-refused">
        {facesRefused.value && say(facesRefused.value)}
      </p>
      <ul class="faces-people" data-testid="faces-people">
        {known?.people.map((person) => (
          <Person key={person.name} {...person} />
        ))}
      </ul>
      {known && known.people.length === 0 && <p>{t('faces_nobody')}</p>}
      {known && known.people.length > 0 && (
        <footer>
          <button
            type="button"
            class="button"
            data-testid="faces-forget-all"
            onClick={() => {
              facesRefused.value = null;
              send({ type: 'faces', action: 'forget_all' });
            }}
          >
            {t('faces_forget_all')}
          </button>
        </footer>
      )}
    </Dialog>
  );
}

/** Opens the list of those whom the robot knows. */
export function openFaces(): void {
  openDialog.value = <FacesDialog />;
}
