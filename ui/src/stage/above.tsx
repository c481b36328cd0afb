import { useComputed } from '@preact/signals';
import { t } from '../messages';
import { above, showAbove } from '../state/panels';
import { Memory } from './memory';
import { Room } from './room';

function Tabs() {
  const tab = (which: 'room' | 'memory', words: string) => (
    <button
      type="button"
      role="tab"
      class="tab"
      data-testid={`tab-${which}`}
      aria-selected={above.value === which}
      onClick={() => showAbove(which)}
    >
      {words}
    </button>
  );
  return (
    <div class="tabs" role="tablist" aria-label={t('from_above')}>
      {tab('room', t('room_above'))}
      {tab('memory', t('memory_above'))}
    </div>
  );
}

/** From above: the room as it is, or the room as the robot remembers it. */
export function Above() {
  const remembered = useComputed(() => above.value === 'memory');
  return remembered.value ? <Memory tabs={<Tabs />} /> : <Room tabs={<Tabs />} />;
}
