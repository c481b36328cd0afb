import { useState } from 'preact/hooks';
import { t } from '../messages';
import { Dialog, closeDialog, openDialog } from './dialog';

interface TextProps {
  question: string;
  start: string;
  check: (text: string) => string | null;
  done: (text: string) => void;
  cancelled: () => void;
}

function AskText({ question, start, check, done, cancelled }: TextProps) {
  const [text, setText] = useState(start);
  const wrong = text.trim() ? check(text.trim()) : null;
  const submit = (event: Event) => {
    event.preventDefault();
    if (!text.trim() || wrong) return;
    closeDialog();
    done(text.trim());
  };
  return (
    <Dialog title={question} onClose={cancelled}>
      <form onSubmit={submit}>
        <input
          data-first
          class="text-input"
          maxLength={80}
          aria-label={question}
          value={text}
          onInput={(event) => setText(event.currentTarget.value)}
          onFocus={(event) => event.currentTarget.select()}
        />
        <p class="field-fault" role="alert">
          {wrong}
        </p>
        <footer>
          <button
            type="button"
            class="button"
            onClick={() => {
              closeDialog();
              cancelled();
            }}
          >
            {t('cancel')}
          </button>
          <button type="submit" class="button primary" disabled={!text.trim() || wrong !== null}>
            {t('ok')}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}

/** Asks for a line of text; `check` gives the words for what is wrong with it, or null. */
export function askText(
  question: string,
  start: string,
  check: (text: string) => string | null,
  done: (text: string) => void,
  cancelled: () => void = () => undefined,
): void {
  openDialog.value = <AskText key={question} {...{ question, start, check, done, cancelled }} />;
}

/** Asks yes or no. */
export function askYes(question: string, yes: string, done: (agreed: boolean) => void): void {
  const answer = (agreed: boolean) => () => {
    closeDialog();
    done(agreed);
  };
  openDialog.value = (
    <Dialog title={question} onClose={() => done(false)}>
      <footer>
        <button type="button" class="button" onClick={answer(false)}>
          {t('cancel')}
        </button>
        <button type="button" class="button primary" data-first onClick={answer(true)}>
          {yes}
        </button>
      </footer>
    </Dialog>
  );
}

/** Tells one thing. */
export function tell(title: string, done: () => void = () => undefined): void {
  openDialog.value = (
    <Dialog title={title} onClose={done}>
      <footer>
        <button
          type="button"
          class="button primary"
          data-first
          onClick={() => {
            closeDialog();
            done();
          }}
        >
          {t('ok')}
        </button>
      </footer>
    </Dialog>
  );
}
