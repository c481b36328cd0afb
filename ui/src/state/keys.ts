/** Keys: Escape always stops; others go to the running program unless somebody writes or works on the canvas. */
import { keyOf } from '../blocks/keys';
import { running, sendKey, stop, youDrive } from './robot';

function isBusy(target: EventTarget | null): boolean {
  if (!(target instanceof Element)) return false;
  return (
    target.closest('input, textarea, select, dialog, [contenteditable], .injectionDiv, .blocklyWidgetDiv') !==
    null
  );
}

function pressesControl(target: EventTarget | null, key: string): boolean {
  return (
    (key === ' ' || key === 'Enter') && target instanceof Element && target.closest('button, a') !== null
  );
}

export function listenToKeys(): void {
  const held = new Set<string>();
  const lift = () => {
    for (const key of held) sendKey(key, false);
    held.clear();
  };
  window.addEventListener(
    'keydown',
    (event) => {
      if (event.key === 'Escape' && running.peek()) stop();
      const key = keyOf(event.key);
      if (!key || !running.peek() || !youDrive.peek() || event.ctrlKey || event.metaKey || event.altKey)
        return;
      if (isBusy(event.target) || pressesControl(event.target, event.key)) return;
      event.preventDefault();
      if (held.has(key)) return;
      held.add(key);
      sendKey(key, true);
    },
    true,
  );
  window.addEventListener('keyup', (event) => {
    const key = keyOf(event.key);
    if (key && held.delete(key)) sendKey(key, false);
  });
  window.addEventListener('blur', lift);
}
