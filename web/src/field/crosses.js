import { bytes } from "../theme.js";

const widest = 0.85; // of the grain's radius

/** Principal stresses of grains as crosses: along each axis a bar of the grain's length, as thick as the stress is
    large against the mean. */
export function crossesOf(result, theme) {
  const bars = [],
    { nodes, x, y } = result.grains;
  for (let g = 0; g < nodes.length; ++g) {
    if (nodes[g] < 4) continue;
    add(bars, result, theme, x[g], y[g], result.radiusOfGrain(g), (id) => result.ofGrain(id, g));
  }
  return bars.sort((a, b) => a.size - b.size);
}

/** The same at nodes of one grain, a stride apart. */
export function crossesInGrain(result, theme, g) {
  const bars = [],
    { map } = result,
    box = result.boxOfGrain(g),
    d = map.spacing;
  const stride = Math.max(1, Math.round(result.radiusOfGrain(g) / d / 7));
  const first = [Math.round(box.left / d), Math.round(box.bottom / d)],
    last = [Math.round(box.right / d), Math.round(box.top / d)];
  for (let j = first[1] + (stride >> 1); j < last[1]; j += stride)
    for (let i = first[0] + (stride >> 1); i < last[0]; i += stride) {
      const k = i + map.width * j;
      if (map.label[k] === g + 1)
        add(bars, result, theme, (i + 0.5) * d, (j + 0.5) * d, 0.46 * stride * d, (id) => result.atNode(id, k));
    }
  return bars.sort((a, b) => a.size - b.size);
}

function add(bars, result, theme, x, y, reach, of) {
  const angle = (of("angle") * Math.PI) / 180;
  for (const [stress, turn] of [
    [of("principal"), angle],
    [of("second"), angle + Math.PI / 2],
  ]) {
    const size = Math.abs(stress) / result.scale;
    if (size < 0.05) continue;
    const half = reach * 0.82,
      dx = half * Math.cos(turn),
      dy = half * Math.sin(turn);
    bars.push({
      ends: [x - dx, y - dy, x + dx, y + dy],
      width: reach * Math.min(widest, 0.16 * size),
      size,
      colour: stress < 0 ? theme.cross.push : theme.cross.pull,
    });
  }
}

/** Bars for the graphics card, relative to `origin`. */
export function barBuffers(bars, origin) {
  const ends = new Float32Array(4 * bars.length),
    width = new Float32Array(bars.length),
    colour = new Uint8Array(4 * bars.length);
  bars.forEach((bar, k) => {
    ends.set([bar.ends[0] - origin.x, bar.ends[1] - origin.y, bar.ends[2] - origin.x, bar.ends[3] - origin.y], 4 * k);
    width[k] = bar.width;
    colour.set([...bytes(bar.colour), bar.size < 1 ? 170 : 255], 4 * k);
  });
  return { ends, width, colour, count: bars.length };
}
