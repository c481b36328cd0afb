import { signal } from '@preact/signals';
import type { Lang, Words } from '../model/words';
import { type MessageKey, en } from './en';
import { es } from './es';

export type { MessageKey } from './en';
export const tables: Record<Lang, Record<MessageKey, string>> = { en, es };

/** The language that everything is shown in; components that read it follow a change at once. */
export const lang = signal<Lang>('en');

export function fill(text: string, values: Record<string, string | number>): string {
  return text.replace(/\{(\w+)\}/g, (whole, key: string) => (key in values ? String(values[key]) : whole));
}

/** The words for `key` in the current language. */
export function t(key: MessageKey, values: Record<string, string | number> = {}): string {
  return fill(tables[lang.value][key], values);
}

/** A text that came in all languages, in the current one. */
export function say(words: Words | undefined): string {
  return words?.[lang.value] ?? words?.en ?? '';
}
