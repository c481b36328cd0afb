import assert from 'node:assert/strict';

/** A stack so long that JSON.stringify cannot write it. */
export function longProgram(n) {
  const parts = [
    '{"format":"mirada-program","version":1,"name":"Long","packs":[],"workspace":{"blocks":{"languageVersion":0,',
  ];
  parts.push('"blocks":[{"type":"event_whenflagclicked","id":"hat","x":20,"y":20');
  for (let i = 1; i < n; i++) {
    const shadow = `{"type":"math_number","id":"s${i}","fields":{"NUM":${i % 10}}}`;
    parts.push(
      `,"next":{"block":{"type":"control_wait","id":"w${i}","inputs":{"DURATION":{"shadow":${shadow}}}`,
    );
  }
  return `${parts.join('')}${'}}'.repeat(n - 1)}}]},"variables":[]}}`;
}

/** The one stack of a program: type, id and seconds of each block. */
export function chainOf({ workspace }) {
  assert.equal(workspace.blocks.blocks.length, 1);
  const chain = [];
  for (let block = workspace.blocks.blocks[0]; block; block = block.next?.block) {
    const seconds = block.inputs?.DURATION.shadow.fields.NUM;
    chain.push([block.type, block.id, seconds].filter((part) => part !== undefined).join(' '));
  }
  return chain;
}
