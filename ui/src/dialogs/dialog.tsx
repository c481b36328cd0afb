import { signal } from '@preact/signals';
import * as Blockly from 'blockly/core';
import type { ComponentChildren, VNode } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { t } from '../messages';
import { stop } from '../state/robot';

/** The one dialog that is open, or null. */
export const openDialog = signal<VNode | null>(null);

export function closeDialog(): void {
  openDialog.value = null;
}

function holdFocus(element: HTMLElement): () => void {
  try {
    return Blockly.getFocusManager().takeEphemeralFocus(element);
  } catch {
    // A menu of Blockly that is still closing holds it; the page's own modal focus is enough then.
    return () => undefined;
  }
}

interface Props {
  title: string;
  wide?: boolean;
  /** A press outside does not close it: there is work in it. */
  firm?: boolean;
  onClose?: () => void;
  children: ComponentChildren;
}

/** A modal window with a title; Escape, the cross and a press outside close it. */
export function Dialog({ title, wide, firm, onClose, children }: Props) {
  const ref = useRef<HTMLDialogElement>(null);
  const close = () => {
    closeDialog();
    onClose?.();
  };
  // Not after the next paint: whoever types at once types into the dialog.
  useLayoutEffect(() => {
    const element = ref.current!;
    const release = holdFocus(element);
    element.showModal();
    element.querySelector<HTMLElement>('[data-first]')?.focus();
    return () => {
      element.close();
      release();
    };
  }, []);
  // What lies behind a modal dialog hears nothing; the red button does all the same.
  const pressedOutside = (event: PointerEvent) => {
    if (event.target !== ref.current) return;
    const button = document.querySelector('[data-testid=stop]')?.getBoundingClientRect();
    const { clientX: x, clientY: y } = event;
    if (button && x >= button.left && x <= button.right && y >= button.top && y <= button.bottom) stop();
    else if (!firm) close();
  };
  return (
    <dialog
      ref={ref}
      class={wide ? 'dialog wide' : 'dialog'}
      aria-label={title}
      onCancel={(event) => {
        event.preventDefault();
        close();
      }}
      onPointerDown={pressedOutside}
    >
      <div class="dialog-body">
        <header>
          <h2>{title}</h2>
          <button type="button" class="icon-button" aria-label={t('close')} onClick={close}>
            ✕
          </button>
        </header>
        {children}
      </div>
    </dialog>
  );
}

export function DialogHost() {
  return openDialog.value;
}
