// Who is it: what build/bench/bin/identity_accuracy prints.
export const order = 45;

const share = (part, all) => (all === 0 ? '-' : (part / all).toFixed(3));

export function section({ looks, rows }) {
  const row = (r) =>
    `| ${r.what} | ${r.how} | ${r.learnt_people} + ${r.stranger_people} | ${r.known} | ${share(r.right, r.known)} | ${share(r.wrong, r.known)} | ${r.strangers} | ${share(r.named, r.strangers)} | ${r.unseen} | ${r.known_5_percent.toFixed(2)} / ${r.strangers_97_percent.toFixed(2)} |`;
  const nets = rows.filter(({ how }) => how === 'network-1');
  const right = nets.every((r) => r.right / r.known >= 0.95);
  const strangers = nets.every((r) => r.named / r.strangers <= 0.03);

  return `## Who is it
${looks} looks are learnt of each person; then each question is one picture that was not learnt from, answered by one look (the blocks ask for two that agree). *Painted*: five of the simulated room's people
and five strangers to it, 0.6 to 1.4 m away, turned by up to 25°, in light from half to one and a half; learnt nearer by, turned by up to 15°, in good light. *Photographed*: somebody in Debian's opencv-doc,
learnt from one photograph and asked for in another, and somebody else, scaled to faces of 30 to 70 pixels, turned in the picture by up to 12°, lighter, darker, blurred and with noise. **Weakness**: painted
faces were chosen so that a network tells them apart, and two people are no class; what this shows is that size, light, turning and noise do not change the answer. With pictures of one's own:
\`scripts/accuracy identity --learnt FOLDER --strangers FOLDER\`, a folder a person in each.

| people | how | learnt + strangers | questions | right | wrong name | strangers' pictures | named | not looked at | likeness: 5 % of the learnt below / 3 % of strangers above |
|---|---|---|---|---|---|---|---|---|---|
${rows.map(row).join('\n')}

- By the networks right at least 0.95: ${right ? 'yes' : '**no**'}; strangers named at most 0.03: ${strangers ? 'yes' : '**no**'}.`;
}
