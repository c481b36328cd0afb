// What is out of view: what tests/bench/memory/remembering.mjs prints.
export const order = 14;

export function section(result) {
  const yes = (truth) => (truth ? 'yes' : '**no**');
  const cm = (metres) => (metres * 100).toFixed(1);
  const share = (part) => `${(part * 100).toFixed(1)} %`;
  return `## Remembered
After one *look around*, 2 m of driving and a quarter turn each fifth degree out of view is asked: five rooms made by chance, one a floor, four seeds each, ${result.remembered} remembered directions. *Off by*: from the remembered place to the nearest thing.

| off by, median | nine of ten within | inside the stated 95 % interval | *clear* that is not |
|---|---|---|---|
| ${cm(result.median_m)} cm | ${cm(result.p90_m)} cm | ${share(result.inside_95)} | ${result.clear_but_blocked} of ${result.clear} |

- Median at most 6 cm, nine of ten within 15 cm: ${yes(result.median_m <= 0.06 && result.p90_m <= 0.15)}.
- The interval holds for 90 to 98 %: ${yes(result.inside_95 >= 0.9 && result.inside_95 <= 0.98)}.`;
}
