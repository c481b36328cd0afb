import { describe, expect, it } from 'vitest';
import { joinChains, linkIn, linkOut, longestWhole, pieceLength, splitChains } from '../src/model/chains';
import { writeJson } from '../src/model/json';
import { type BlockState, eachBlock } from '../src/model/program';
import { stack, wait, workspaceOf } from './support';

const long = (n: number, name = 'b') => stack(...Array.from({ length: n }, (_, i) => wait(`${name}${i}`)));

function chainLengths(tops: BlockState[]): number[] {
  return tops.map((top) => {
    let n = 1;
    for (let next = top.next?.block; next; next = next.next?.block) n += 1;
    return n;
  });
}

describe('long stacks', () => {
  it('a stack of ordinary length stays whole', () => {
    const workspace = workspaceOf({ ...long(longestWhole), x: 5, y: 6 });
    const before = writeJson(workspace);
    splitChains(workspace);
    expect(writeJson(workspace)).toBe(before);
  });

  it('5,000 blocks become short pieces and come back as they were', () => {
    const workspace = workspaceOf({ ...long(5000), x: 5, y: 6 }, { ...wait('other'), x: 1, y: 2 });
    const before = writeJson(workspace);
    splitChains(workspace);
    const lengths = chainLengths(workspace.blocks!.blocks);
    expect(Math.max(...lengths)).toBeLessThanOrEqual(pieceLength + 2);
    expect(lengths.length).toBe(Math.ceil(5000 / pieceLength) + 1);
    joinChains(workspace);
    expect(writeJson(workspace)).toBe(before);
  });

  it('a long stack inside a loop comes back as it was', () => {
    const loop: BlockState = {
      type: 'control_forever',
      id: 'f',
      x: 0,
      y: 0,
      inputs: { SUBSTACK: { block: long(1000) } },
    };
    const workspace = workspaceOf(loop);
    const before = writeJson(workspace);
    splitChains(workspace);
    expect(workspace.blocks!.blocks.length).toBe(Math.ceil(1000 / pieceLength));
    joinChains(workspace);
    expect(writeJson(workspace)).toBe(before);
  });

  it('loses nothing when a link was thrown away or leads to itself', () => {
    const out = (n: string): BlockState => ({ type: linkOut, fields: { LINK: n } });
    const into = (n: string, rest: BlockState): BlockState => ({
      type: linkIn,
      fields: { LINK: n },
      x: 1,
      y: 1,
      next: { block: rest },
    });
    const workspace = workspaceOf(
      stack(wait('a'), out('9')),
      into('1', wait('lonely')),
      into('2', stack(wait('circle'), out('2'))),
      out('3'),
    );
    joinChains(workspace);
    const ids = [...eachBlock(workspace)].map((block) => block.id).filter((id) => !id?.endsWith('s'));
    expect(ids.sort()).toEqual(['a', 'circle', 'lonely']);
    expect(writeJson(workspace)).not.toContain('mirada_');
  });
});
