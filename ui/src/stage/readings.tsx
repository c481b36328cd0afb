import { useComputed, useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { say, t } from '../messages';
import { editor } from '../state/editor';
import { faults, notes, telemetry } from '../state/robot';
import type { Value } from '../wire/protocol';

const shownItems = 100;

function words(value: Value): string {
  if (typeof value === 'number') return String(Math.round(value * 100) / 100);
  return value === null ? '' : String(value);
}

function dataHue(): string {
  const packs = editor.value?.catalog.packs ?? [];
  return packs.find((pack) => pack.id === 'data')?.colour ?? '#ff8c1a';
}

function Values() {
  const now = telemetry.value;
  const variables = Object.entries(now?.variables ?? {});
  const lists = Object.entries(now?.lists ?? {});
  if (variables.length + lists.length === 0) return <p class="quiet">{t('no_values')}</p>;
  return (
    <div class="values" style={{ '--hue': dataHue() }}>
      {variables.map(([name, value]) => (
        <div key={name} class="monitor" data-variable={name}>
          <span>{name}</span>
          <output>{words(value)}</output>
        </div>
      ))}
      {lists.map(([name, values]) => (
        <div key={name} class="monitor list" data-list={name}>
          <span>
            {name} <small>{t('list_length', { n: now?.list_lengths[name] ?? values.length })}</small>
          </span>
          <ol>
            {values.length === 0 && <li class="quiet">{t('empty_list')}</li>}
            {values.slice(0, shownItems).map((value, index) => (
              <li key={index}>{words(value)}</li>
            ))}
            {values.length > shownItems && <li class="quiet">{t('list_goes_on')}</li>}
          </ol>
        </div>
      ))}
    </div>
  );
}

function Log() {
  const end = useRef<HTMLDivElement>(null);
  const lines = notes.value;
  const said = telemetry.value?.say_log ?? [];
  useEffect(() => end.current?.scrollIntoView({ block: 'nearest' }), [lines.length, said.length]);
  if (lines.length + said.length + faults.value.length === 0) return <p class="quiet">{t('no_log')}</p>;
  return (
    <div class="log" role="log">
      {lines.map((line) => (
        <p key={line.at} class={line.severity}>
          {line.words()}
        </p>
      ))}
      {said.map((line, index) => (
        <p key={`s${index}`} class="said">
          <time>{line.t_s.toFixed(1)} s</time> {line.text}
        </p>
      ))}
      {faults.value.map((fault, index) => (
        <p key={`f${index}`} class={fault.severity}>
          {say(fault.message)}{' '}
          <button type="button" class="link" onClick={() => editor.value?.reveal(fault.place)}>
            {t('go_to_block')}
          </button>
        </p>
      ))}
      <div ref={end} />
    </div>
  );
}

/** Values and log, as tabs. */
export function Readings() {
  const tab = useSignal<'values' | 'log'>('values');
  const trouble = useComputed(() => faults.value.length);
  return (
    <section class="card readings">
      <header class="card-head" role="tablist">
        {(['values', 'log'] as const).map((name) => (
          <button
            key={name}
            type="button"
            role="tab"
            class="tab"
            aria-selected={tab.value === name}
            onClick={() => {
              tab.value = name;
            }}
          >
            {t(name)}
            {name === 'log' && trouble.value > 0 && <span class="count">{trouble}</span>}
          </button>
        ))}
      </header>
      <div class="readings-body" role="tabpanel" aria-label={t(tab.value)}>
        {tab.value === 'values' ? <Values /> : <Log />}
      </div>
    </section>
  );
}
