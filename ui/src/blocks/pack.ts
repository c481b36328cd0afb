/** The packs as the robot sends them (docs/pack-authoring.md) and look-ups in them. */
import type { Words } from '../model/words';

export type Shape = 'command' | 'reporter' | 'boolean' | 'hat' | 'cap' | 'c_block';
export type ArgType =
  'number' | 'angle' | 'text' | 'boolean' | 'menu' | 'key' | 'variable' | 'list' | 'broadcast' | 'statements';

export interface PackArg {
  name: string;
  type: ArgType;
  unit?: string;
  min?: number;
  max?: number;
  default?: number | string | boolean | Words;
  options?: { value: string; text: Words }[];
}

export interface PackBlock {
  opcode: string;
  shape: Shape;
  text: Words;
  args?: PackArg[];
  needs?: string[];
  help?: Words;
  implementation: string;
  visible?: boolean;
  toolbox?: boolean;
  /** A C-block that nothing can follow. */
  cap?: boolean;
}

export interface Pack {
  id: string;
  version: string;
  order?: number;
  colour: string;
  name: Words;
  blocks: PackBlock[];
}

export interface Known {
  pack: Pack;
  block: PackBlock;
}

/** All blocks of all packs, by opcode. */
export class Catalog {
  readonly packs: readonly Pack[];
  private readonly known = new Map<string, Known>();

  constructor(packs: readonly Pack[]) {
    this.packs = packs;
    for (const pack of packs) {
      for (const block of pack.blocks) this.known.set(block.opcode, { pack, block });
    }
  }

  find(opcode: string): Known | undefined {
    return this.known.get(opcode);
  }

  /** The packs that these blocks come from, in the catalog's order. */
  packsOf(opcodes: Iterable<string>): string[] {
    const used = new Set<string>();
    for (const opcode of opcodes) {
      const pack = this.known.get(opcode)?.pack.id;
      if (pack) used.add(pack);
    }
    return this.packs.map((pack) => pack.id).filter((id) => used.has(id));
  }

  /** The blocks that begin a stack by themselves. */
  hats(): string[] {
    return [...this.known.values()]
      .filter(({ block }) => block.shape === 'hat')
      .map(({ block }) => block.opcode);
  }

  /** The colour of the first pack with a reporter that needs this percept: its overlay wears it. */
  hueOf(percept: string, otherwise: string): string {
    const tells = (block: PackBlock) => block.shape === 'reporter' || block.shape === 'boolean';
    const has = (pack: Pack) => pack.blocks.some((block) => tells(block) && block.needs?.includes(percept));
    return this.packs.find(has)?.colour ?? otherwise;
  }
}

/** Whether a stack ends with this block. */
export function endsStack(block: PackBlock): boolean {
  return block.shape === 'cap' || block.cap === true;
}

/** The sentence of a block cut at its arguments: text and argument names by turns. */
export function cutText(text: string): ({ text: string } | { arg: string })[] {
  return text
    .split(/(\[[A-Za-z0-9_]+\])/)
    .filter((part) => part !== '')
    .map((part) => (/^\[[A-Za-z0-9_]+\]$/.test(part) ? { arg: part.slice(1, -1) } : { text: part }));
}
