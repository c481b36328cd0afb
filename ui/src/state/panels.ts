/** Which panels are open, and whether the stage is folded away. The robot only works for what is open. */
import { effect, signal } from '@preact/signals';
import type { Watch } from '../wire/protocol';
import { wizardOpen } from './calibration';
import { watch } from './robot';

const key = 'mirada.panels';

type Above = 'room' | 'memory';

function kept(): { folded: boolean; sonar: boolean; faces: boolean; above: Above } {
  const otherwise = { folded: false, sonar: true, faces: false, above: 'room' as Above };
  try {
    return { ...otherwise, ...(JSON.parse(localStorage.getItem(key) ?? '{}') as object) };
  } catch {
    return otherwise;
  }
}

const start = kept();
export const folded = signal(start.folded);
/** Which tab shows the floor from above. */
export const above = signal<Above>(start.above === 'memory' ? 'memory' : 'room');
export const panels = signal({ sonar: start.sonar, faces: start.faces });

export function togglePanel(panel: 'sonar' | 'faces'): void {
  panels.value = { ...panels.value, [panel]: !panels.value[panel] };
}

export function showAbove(which: Above): void {
  above.value = which;
}

export function keepPanels(): void {
  const hidden = signal(document.hidden);
  document.addEventListener('visibilitychange', () => {
    hidden.value = document.hidden;
  });
  effect(() => {
    localStorage.setItem(key, JSON.stringify({ folded: folded.value, above: above.value, ...panels.value }));
    const open = !folded.value && !hidden.value;
    const wanted: Watch = {
      camera: open || wizardOpen.value,
      sonar: open && panels.value.sonar,
      faces: open && panels.value.faces,
      room: open && above.value === 'room',
      memory: open && above.value === 'memory',
    };
    watch(wanted);
  });
}
