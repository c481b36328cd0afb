import type { Words } from '../model/words';

/** Names of the keys in a program (docs/program-format.md), and what a person calls them. */
const named: Record<string, Words> = {
  space: { en: 'space', es: 'espacio' },
  'up arrow': { en: 'up arrow', es: 'flecha arriba' },
  'down arrow': { en: 'down arrow', es: 'flecha abajo' },
  'left arrow': { en: 'left arrow', es: 'flecha izquierda' },
  'right arrow': { en: 'right arrow', es: 'flecha derecha' },
  enter: { en: 'enter', es: 'intro' },
  any: { en: 'any', es: 'cualquiera' },
};

export const keyNames: string[] = [...Object.keys(named), ...'abcdefghijklmnopqrstuvwxyz', ...'0123456789'];

export function keyWords(name: string): Words {
  return named[name] ?? { en: name, es: name };
}

const fromBrowser: Record<string, string> = {
  ' ': 'space',
  ArrowUp: 'up arrow',
  ArrowDown: 'down arrow',
  ArrowLeft: 'left arrow',
  ArrowRight: 'right arrow',
  Enter: 'enter',
};

/** The program's name of a key of the browser (KeyboardEvent.key), or null when programs have no name for it. */
export function keyOf(browserKey: string): string | null {
  const name = fromBrowser[browserKey] ?? browserKey.toLowerCase();
  return name !== 'any' && keyNames.includes(name) ? name : null;
}
