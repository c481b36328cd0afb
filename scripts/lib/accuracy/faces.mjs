// Faces: what build/bench/bin/face_accuracy prints.
export const order = 40;

const share = (part, all) => (all === 0 ? '-' : (part / all).toFixed(3));

export function section({ composites, turned, distances, backs, skipping, cost }) {
  const row = ({ what, detector, faces, hits, false: wrong }) =>
    `| ${what} | ${detector} | ${faces} | ${share(hits, faces)} | ${share(hits, hits + wrong)} |`;
  const main = composites.find(({ what, detector }) => what === '24 to 48 px' && detector === 'ultraface');
  const good = main.hits / main.faces >= 0.95 && main.hits / (main.hits + main.false) >= 0.98;
  const nets = turned.filter(({ detector }) => detector === 'ultraface');
  const haars = turned.filter(({ detector }) => detector === 'haar');
  const saved = ({ what, pictures, haar_everywhere: all, haar }) =>
    `| ${what} (${pictures}) | ${all.mean_ms.toFixed(1)} ms | ${haar.mean_ms.toFixed(1)} ms | ${Math.round(100 * (1 - haar.mean_ms / all.mean_ms)) || 0} % | ${all.hits} and ${haar.hits} | ${all.false} and ${haar.false} |`;
  const worst = Math.max(...distances.map(({ median_error }) => median_error));

  return `## Faces
Two heads from Debian's opencv-doc, seen from the front, scaled into 20 of its photographs without faces, 320 x 240, with noise. **Weakness**: two heads are few, so this says how size and light tell, not
how well all people are found. A hit overlaps the true box by more than 0.4.

| picture | detector | faces | recall | precision |
|---|---|---|---|---|
${composites.map(row).join('\n')}

- Recall at least 0.95 at precision at least 0.98 from 24 pixels on: ${good ? 'yes' : '**no**'}.

Painted people of the simulated room, 0.7 to 1.6 m away, found with the head turned:

| turned | ultraface | haar |
|---|---|---|
${nets.map(({ turned_deg, hits, faces }, i) => `| ${turned_deg}° | ${hits} of ${faces} | ${haars[i].hits} of ${haars[i].faces} |`).join('\n')}

Distance by the face's size, people of 0.9 to 1.8 m:

| distance | found | median error |
|---|---|---|
${distances.map(({ m, faces, found, median_error }) => `| ${m} m | ${found} of ${faces} | ${(100 * median_error).toFixed(1)} % |`).join('\n')}

- Median error at most 8 % between 0.5 and 2.5 m: ${worst <= 0.08 ? 'yes' : '**no**'}.

Backs: six people who showed their face for a second, then turned round, followed by their clothes for the 0.7 seconds after that; how far away is told by the clothes' width, less surely than by a face. In no
picture may a back pass for a face.

| distance | found | median error of the bearing | of the distance | pictures with a face said |
|---|---|---|---|---|
${backs.map(({ m, pictures, found, as_face, bearing_deg, distance_error }) => `| ${m} m | ${found} of ${pictures} | ${bearing_deg.toFixed(1)}° | ${(100 * distance_error).toFixed(0)} % | ${as_face} |`).join('\n')}

Where a face may be: Haar leaves out the squares that are too plain for one, size by size (the paper skips uniform regions; one rule for all regions keeps everything, for in each lies some edge). Time of one
search, on the same pictures by turns. The network reads a picture of one size and cannot leave anything out.

| pictures | Haar everywhere | Haar as it is | saves | faces found | false |
|---|---|---|---|---|---|
${skipping.map(saved).join('\n')}

- A picture costs ${cost.mean_ms.toFixed(1)} ms in the mean (median ${cost.median_ms.toFixed(1)}, 95 % under ${cost.p95_ms.toFixed(1)}), 20 pictures a second, one thread: searched whole about five times a second, followed between. Mean below 3 ms: ${cost.mean_ms < 3 ? 'yes' : '**no**'}.`;
}
