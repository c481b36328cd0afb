import { Catalog, type Pack } from '../src/blocks/pack';
import type { BlockState, WorkspaceState } from '../src/model/program';

const packFiles = import.meta.glob<Pack>('../../blocks/*/pack.json', { eager: true, import: 'default' });
const exampleFiles = import.meta.glob<object>('../../blocks/*/examples/*.json', {
  eager: true,
  import: 'default',
});

/** The packs that ship, as the robot would send them. */
export function shippedCatalog(): Catalog {
  return new Catalog(Object.values(packFiles).sort((a, b) => (a.order ?? 0) - (b.order ?? 0)));
}

/** Every example program that ships. */
export function shippedExamples(): { file: string; text: string }[] {
  return Object.entries(exampleFiles).map(([file, program]) => ({ file, text: JSON.stringify(program) }));
}

export function workspaceOf(...blockList: BlockState[]): WorkspaceState {
  return { blocks: { languageVersion: 0, blocks: blockList } };
}

/** A stack of these blocks. */
export function stack(...list: BlockState[]): BlockState {
  for (let i = list.length - 1; i > 0; i--) list[i - 1]!.next = { block: list[i]! };
  return list[0]!;
}

export function wait(id: string, seconds = 1): BlockState {
  const shadow = { type: 'math_number', id: `${id}s`, fields: { NUM: seconds } };
  return { type: 'control_wait', id, inputs: { DURATION: { shadow } } };
}
