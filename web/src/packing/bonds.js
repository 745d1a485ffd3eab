import { s } from "../dom.js";

const crackShare = 0.9; // of the smaller radius, on either side
const farthest = 1.5; // of the radii's sum: beyond it there are two pieces, and no crack to be seen

/** Ways of breaking, as `broken` of a state counts them from 1; only bonds in space twist. */
export const ways = ["tension", "bending", "shear", "twisting"];

/** What cracks mean: [{ name, colour }] of the ways in which bonds of a state have broken. */
export const crackKey = ({ bonds }, theme) =>
  ways.map((name, k) => ({ name, colour: theme.broken[k] })).filter((_, k) => bonds?.broken.includes(k + 1));

/** Bonds that hold as thin lines from centre to centre, and a crack across each that broke, where its grains are still
    near; none across a periodic side. */
export function bondShapes(sample, snapshot, camera, theme) {
  const { i, j, broken } = snapshot.bonds;
  const box = sample.box(snapshot);
  const wide = (box.right - box.left) / 2,
    high = (box.top - box.bottom) / 2;
  const whole = [],
    cracks = ways.map(() => []);
  for (let b = 0; b < i.length; ++b) {
    const ax = snapshot.x[i[b]],
      ay = snapshot.y[i[b]],
      dx = snapshot.x[j[b]] - ax,
      dy = snapshot.y[j[b]] - ay;
    if (Math.abs(dx) > wide || Math.abs(dy) > high) continue;
    if (broken[b] === 0) {
      whole.push(line(camera, ax, ay, ax + dx, ay + dy));
      continue;
    }
    const ri = sample.radius[i[b]],
      rj = sample.radius[j[b]],
      share = ri / (ri + rj),
      length = Math.hypot(dx, dy);
    if (length > farthest * (ri + rj)) continue;
    const half = (crackShare * Math.min(ri, rj)) / length,
      x = ax + share * dx,
      y = ay + share * dy;
    cracks[broken[b] - 1].push(line(camera, x - half * dy, y + half * dx, x + half * dy, y - half * dx));
  }
  const path = (lines, stroke, width, name) =>
    s("path", {
      d: lines.join(""),
      fill: "none",
      stroke,
      "stroke-width": width,
      "stroke-linecap": "round",
      class: name,
    });
  return [
    path(whole, theme.soft, 0.6, "bonds"),
    ...ways.map((name, k) => path(cracks[k], theme.broken[k], 2, `cracks ${name}`)),
  ].filter((shape) => shape.getAttribute("d"));
}

function line(camera, ax, ay, bx, by) {
  const [x1, y1] = camera.toScreen(ax, ay),
    [x2, y2] = camera.toScreen(bx, by);
  return `M${x1.toFixed(1)} ${y1.toFixed(1)}L${x2.toFixed(1)} ${y2.toFixed(1)}`;
}
