import { s } from "../dom.js";

/** Pairs of grains of a state ({ i, j }) whose centres are not across a periodic side from each other: the place of
    each among all pairs, the centre of its first grain, the way to the second, and both radii. */
export function pairsSeen(sample, snapshot, { i, j }) {
  const box = sample.box(snapshot),
    wide = (box.right - box.left) / 2,
    high = (box.top - box.bottom) / 2;
  return Array.from(i, (a, pair) => {
    const b = j[pair],
      ax = snapshot.x[a],
      ay = snapshot.y[a],
      dx = snapshot.x[b] - ax,
      dy = snapshot.y[b] - ay;
    return { pair, ax, ay, dx, dy, length: Math.hypot(dx, dy), ri: sample.radius[a], rj: sample.radius[b] };
  }).filter(({ dx, dy }) => Math.abs(dx) <= wide && Math.abs(dy) <= high);
}

/** A line from point to point of the plane as a part of a path on the screen. */
export function line(camera, ax, ay, bx, by) {
  const [x1, y1] = camera.toScreen(ax, ay),
    [x2, y2] = camera.toScreen(bx, by);
  return `M${x1.toFixed(1)} ${y1.toFixed(1)}L${x2.toFixed(1)} ${y2.toFixed(1)}`;
}

/** Lines of several kinds as a path each, [[lines, stroke, width, name]]; those without lines are left out. */
export const strokes = (kinds) =>
  kinds
    .filter(([lines]) => lines.length > 0)
    .map(([lines, stroke, width, name]) =>
      s("path", {
        d: lines.join(""),
        fill: "none",
        stroke,
        "stroke-width": width,
        "stroke-linecap": "round",
        class: name,
      }),
    );
