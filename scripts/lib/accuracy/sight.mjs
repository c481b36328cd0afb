// The first sight of something new: what build/bench/bin/memory_accuracy sight prints.
export const order = 17;

const names = { around: 'all round, where looking is worth most', zones: "the paper's three zones in turn", ranks: 'three zones, ahead first' };

export function section({ runs }) {
  const yes = (truth) => (truth ? 'yes' : '**no**');
  const mine = (way) => runs.filter((run) => run.watching === way);
  const times = (way) => mine(way).filter((run) => run.after_s !== null).map((run) => run.after_s).sort((a, b) => a - b);
  const mean = (way) => times(way).reduce((sum, t) => sum + t, 0) / times(way).length;
  const row = (way) => {
    const t = times(way);
    const part = (share) => t[Math.floor(share * (t.length - 1))].toFixed(2);
    return `| ${names[way]} | ${t.length} of ${mine(way).length} | ${mean(way).toFixed(2)} s | ${part(0.5)} s | ${part(0.9)} s | ${mine(way).filter((run) => run.imagined).length} |`;
  };
  // The same things for both: seeds in which neither told of one before it was there.
  const after = (way, seed) => mine(way).find((run) => run.seed === seed)?.after_s ?? null;
  const both = mine('around').map((run) => run.seed).filter((seed) => after('around', seed) !== null && after('zones', seed) !== null);
  const pair = (way) => both.reduce((sum, seed) => sum + after(way, seed), 0) / both.length;
  const less = 1 - pair('around') / pair('zones');
  return `## First sight
A robot that stands keeps an eye on what is around it; at a random moment an obstacle stands 0.5 to 1.4 m away in a random direction within 86° to both sides, which every one of these ways of looking shows. How
long until a block knows of it, the picture's and the answer's latency included.

| keeps an eye on | seen within 8 s | mean | median | nine of ten | told of one before |
|---|---|---|---|---|---|
${Object.keys(names).map(row).join('\n')}

- Sooner than the paper's zones by at least 25 % in the mean: ${yes(less >= 0.25)} (${(100 * less).toFixed(0)} %: ${pair('around').toFixed(2)} s and ${pair('zones').toFixed(2)} s over the ${both.length} seeds in which both saw it and neither told of one before it stood there).`;
}
