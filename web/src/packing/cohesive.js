import { line, pairsSeen, strokes } from "./strokes.js";

const into = 0.35; // of the smaller radius: how far a stroke reaches into either grain

/** Pairs that adhesion or a liquid bridge joins: a stroke across the contact or the gap, in the colour of tension where
    the grains are apart; none across a periodic side. */
export function cohesiveShapes(sample, snapshot, camera, theme) {
  const touching = [],
    apart = [];
  for (const { pair, ax, ay, dx, dy, length, ri, rj } of pairsSeen(sample, snapshot, snapshot.cohesive)) {
    const reach = into * Math.min(ri, rj),
      from = (ri - reach) / length,
      to = 1 - (rj - reach) / length;
    const lines = snapshot.cohesive.gap[pair] > 0 ? apart : touching;
    lines.push(line(camera, ax + from * dx, ay + from * dy, ax + to * dx, ay + to * dy));
  }
  return strokes([
    [touching, theme.materialLine[0], 1.2, "cohesive touching"],
    [apart, theme.tension, 1.6, "cohesive apart"],
  ]);
}
