import { drawn, ways } from "../drawn.js";
import { line, pairsSeen, strokes } from "./strokes.js";

/** What cracks mean: [{ name, colour }] of the ways in which bonds of a state have broken. */
export const crackKey = ({ bonds }, theme) =>
  ways()
    .map((name, k) => ({ name, colour: theme.broken[k] }))
    .filter((_, k) => bonds?.broken.includes(k + 1));

/** Bonds that hold as thin lines from centre to centre, and a crack across each that broke, where its grains are still
    near; none across a periodic side. */
export function bondShapes(sample, snapshot, camera, theme) {
  const { crack } = drawn(),
    whole = [],
    cracks = ways().map(() => []);
  for (const { pair, ax, ay, dx, dy, length, ri, rj } of pairsSeen(sample, snapshot, snapshot.bonds)) {
    const broken = snapshot.bonds.broken[pair];
    if (broken === 0) {
      whole.push(line(camera, ax, ay, ax + dx, ay + dy));
      continue;
    }
    if (length > crack.farthest * (ri + rj)) continue;
    const share = ri / (ri + rj),
      half = (crack.half * Math.min(ri, rj)) / length,
      x = ax + share * dx,
      y = ay + share * dy;
    cracks[broken - 1].push(line(camera, x - half * dy, y + half * dx, x + half * dy, y - half * dx));
  }
  return strokes([
    [whole, theme.soft, 0.6, "bonds"],
    ...ways().map((name, k) => [cracks[k], theme.broken[k], 2, `cracks ${name}`]),
  ]);
}
