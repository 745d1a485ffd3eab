import { bytes } from "../theme.js";
import { displacedBy } from "./deformation.js";

/** How many bonds are broken at a step of the curve. */
export function brokenAt(result, step) {
  if (!result.cracks) return 0;
  return Math.min(result.cracks.x.length, Math.round(result.curve.broken?.[step] ?? result.cracks.x.length));
}

/** How many of the first `count` are of each type. */
export function byType(result, count) {
  const counts = [0, 0, 0, 0];
  for (let k = 0; k < count; ++k) ++counts[result.cracks.type[k]];
  return counts;
}

/** Dots at broken bonds for the graphics card, `times` displaced: segments too short to be seen as such. */
export function crackBuffers(result, count, theme, origin, times = 0) {
  const { x, y, type } = result.cracks,
    { dx } = result.map.about;
  const ends = new Float32Array(4 * count),
    width = new Float32Array(count),
    colour = new Uint8Array(4 * count);
  const paints = theme.crack.map((name) => name && [...bytes(name), 255]);
  for (let k = 0; k < count; ++k) {
    const [at, up] = times ? displacedBy(result, x[k], y[k], times) : [x[k], y[k]],
      px = at - origin.x,
      py = up - origin.y;
    ends.set([px - 0.02 * dx, py, px + 0.02 * dx, py], 4 * k);
    width[k] = 1.1 * dx;
    colour.set(paints[type[k]] ?? paints[1], 4 * k);
  }
  return { ends, width, colour, count };
}
