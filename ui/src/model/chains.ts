/**
 * Blockly nests the blocks of a stack in each other, on the page too: building a stack takes time that grows with the
 * square of its length, and some 2,000 blocks overflow the browser. So the editor shows a long stack in pieces of its own,
 * joined by a pair of link blocks; a saved program never holds them.
 */
import type { BlockState, WorkspaceState } from './program';

export const linkOut = 'mirada_continues';
export const linkIn = 'mirada_continued';
/** Stacks up to this long stay in one piece; the pieces of longer ones have `pieceLength` blocks. */
export const longestWhole = 300;
export const pieceLength = 120;
const columnWidth = 480;

function chainOf(first: BlockState): BlockState[] {
  const chain = [first];
  for (let next = first.next?.block; next; next = next.next?.block) chain.push(next);
  return chain;
}

/** Starts of all chains below these blocks: the blocks themselves and what their inputs hold. */
function* eachChain(tops: BlockState[]): Generator<BlockState[]> {
  const open = [...tops];
  for (let first = open.pop(); first; first = open.pop()) {
    const chain = chainOf(first);
    yield chain;
    for (const block of chain) {
      for (const input of Object.values(block.inputs ?? {})) if (input.block) open.push(input.block);
    }
  }
}

function cut(block: BlockState, link: number): BlockState | undefined {
  const rest = block.next?.block;
  block.next = { block: { type: linkOut, fields: { LINK: String(link) } } };
  return rest;
}

/** Cuts long chains, in place, into pieces that Blockly can carry. */
export function splitChains(workspace: WorkspaceState): void {
  const tops = workspace.blocks?.blocks;
  if (!tops) return;
  let link = 0;
  const pieces: BlockState[] = [];
  for (const top of tops) {
    for (const chain of eachChain([top])) {
      if (chain.length <= longestWhole) continue;
      for (let at = pieceLength; at < chain.length; at += pieceLength) {
        link += 1;
        const rest = cut(chain[at - 1]!, link);
        const x = (top.x ?? 0) + link * columnWidth;
        pieces.push({
          type: linkIn,
          fields: { LINK: String(link) },
          x,
          y: top.y ?? 0,
          next: { block: rest },
        });
      }
    }
  }
  tops.push(...pieces);
}

interface Piece {
  first: BlockState;
  x?: number;
  y?: number;
}

/** Removes the pieces from the tops: what follows each link, and where it stood. */
function takePieces(tops: BlockState[]): Map<string, Piece> {
  const pieces = new Map<string, Piece>();
  for (let i = tops.length - 1; i >= 0; i--) {
    const top = tops[i]!;
    if (top.type !== linkIn) continue;
    const first = top.next?.block;
    if (first) pieces.set(String(top.fields?.LINK), { first, x: top.x, y: top.y });
    tops.splice(i, 1);
  }
  return pieces;
}

function join(first: BlockState, pieces: Map<string, Piece>): void {
  const open = [first];
  for (let block = open.pop(); block; block = open.pop()) {
    for (const input of Object.values(block.inputs ?? {})) {
      if (input.block?.type === linkOut) delete input.block;
      if (input.block) open.push(input.block);
    }
    const next = block.next?.block;
    if (next?.type === linkOut) {
      const link = String(next.fields?.LINK);
      const rest = pieces.get(link);
      pieces.delete(link);
      if (rest) block.next = { block: rest.first };
      else delete block.next;
    }
    if (block.next?.block) open.push(block.next.block);
  }
}

/** Joins the pieces again, in place. A piece whose other half was thrown away stays as a stack of its own. */
export function joinChains(workspace: WorkspaceState): void {
  const tops = workspace.blocks?.blocks;
  if (!tops) return;
  const pieces = takePieces(tops);
  for (const top of tops) join(top, pieces);
  for (const [link, piece] of pieces) {
    pieces.delete(link);
    join(piece.first, pieces);
    tops.push({ ...piece.first, x: piece.x, y: piece.y });
  }
  for (let i = tops.length - 1; i >= 0; i--) if (tops[i]!.type === linkOut) tops.splice(i, 1);
}
