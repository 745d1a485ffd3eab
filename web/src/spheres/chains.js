import { kindOfForce, ways, widthOfForce } from "../drawn.js";
import { bytes } from "../theme.js";

const thinnest = 0.015; // radius of a line over the mean radius, that it may be seen

/** How thick a force is drawn, the radius of its line, m. */
export const thicknessOf = (result, force) =>
  Math.max(thinnest * result.meanRadius, widthOfForce(force, result.meanForce, result.meanRadius) / 2);

/** The lines along which forces act: { ends: [ax, ay, az, bx, by, bz, ..] from the middle, radius, kind }. What acts
    across a side of a periodic cell is half a line at both spheres; a wall is met straight ahead. */
export function linesOf(result) {
  const { forces, balls, container, shift } = result.state,
    ends = [],
    radius = [],
    kind = [];
  const at = (g) => [0, 1, 2].map((axis) => balls[4 * g + axis]),
    scale = result.state.force_scale;
  forces.fn.forEach((force, c) => {
    const [i, j] = [forces.i[c], forces.j[c]],
      from = at(i);
    const lines = j < result.count ? between(from, at(j), container) : toWall(from, j - result.count, container, shift);
    for (const line of lines) {
      ends.push(...line);
      radius.push(thicknessOf(result, force));
      kind.push(kindOfForce(force, scale));
    }
  });
  return { ends: new Float32Array(ends), radius: new Float32Array(radius), kind };
}

/** From one sphere to the nearest image of another. */
export function between(a, b, { size, periodic, tilt }) {
  const way = b.map((place, axis) => place - a[axis]);
  let crossed = false;
  for (const axis of [2, 1, 0]) {
    const cells = periodic[axis] ? Math.round(way[axis] / size[axis]) : 0;
    if (cells === 0) continue;
    crossed = true;
    way[axis] -= cells * size[axis];
    if (axis === 1) way[0] -= cells * tilt;
  }
  if (!crossed) return [[...a, ...b]];
  const half = (from, sign) => [...from, ...from.map((place, axis) => place + (sign * way[axis]) / 2)];
  return [half(a, 1), half(b, -1)];
}

function toWall(from, side, { size }, shift) {
  const axis = Math.floor(side / 2),
    end = [...from];
  end[axis] = shift[axis] + (side % 2 ? 0.5 : -0.5) * size[axis];
  return [[...from, ...end]];
}

/** RGBA of every line: of forces, of bonds and where they broke, and of boundaries. */
export function coloursOfLines({ kind }, theme) {
  const { strong, weak, tension, wall } = theme,
    named = { strong, weak, tension, bond: weak, boundary: wall };
  ways().forEach((way, k) => (named[way] = theme.broken[k]));
  const table = Object.fromEntries(Object.entries(named).map(([name, colour]) => [name, [...bytes(colour), 255]])),
    colours = new Uint8Array(4 * kind.length);
  kind.forEach((name, k) => colours.set(table[name], 4 * k));
  return colours;
}
