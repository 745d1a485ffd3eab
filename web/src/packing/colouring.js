import { bytes, materialColour } from "../theme.js";

/** How far grains fade towards the background while force chains lie over them. */
export const fadeUnderChains = (mode) => (mode === "material" ? 0.5 : 0.3);

/** How grains may be coloured. A member gives: label; `scale(sample)` = { low, high, symbol, unit } or null where the
    colours are names; `colour(sample, frame, theme)` = function from a grain to a colour. A new one is one more row. */
export const colourings = {
  material: {
    label: "Material",
    scale: () => null,
    colour: (sample, frame, theme) => {
      const table = sample.materials.map((_, m) => materialColour(theme, m));
      return (g) => table[sample.material[g]];
    },
  },
  size: {
    label: "Size",
    scale: (sample) => {
      const [low, high] = extent(sample.radius);
      return { low: 2e3 * low, high: 2e3 * high, title: "Diameter, mm", map: "size" };
    },
    colour: (sample, frame, theme) => {
      const [low, high] = extent(sample.radius);
      return ramp(theme.size, (g) => (high > low ? (sample.radius[g] - low) / (high - low) : 0.5));
    },
  },
  stress: {
    label: "\u03c3_{norm}",
    scale: (sample) => ({ low: 0, high: stressTop(sample), title: "\u03c3_{norm} = \u03c3_{hyd} / \u27e8\u03c3_{hyd}\u27e9", map: "stress", open: true }),
    colour: (sample, frame, theme) => {
      const top = stressTop(sample);
      return ramp(theme.stress, (g) => frame.sigmaNorm[g] / top);
    },
  },
  zone: {
    label: "Zone",
    when: (sample) => sample.hasZones,
    scale: () => null,
    colour: (sample, frame, theme) => (g) => (sample.zone[g] > 0 ? theme.materialLine[(sample.zone[g] + 1) % 4] : theme.weak),
  },
};

function extent(values) {
  let low = Infinity, high = -Infinity;
  for (const v of values) { if (v < low) low = v; if (v > high) high = v; }
  return [low, high];
}

function ramp(map, of) {
  const table = Array.from({ length: 256 }, (_, k) => map(k / 255));
  return (g) => table[Math.round(255 * Math.min(1, Math.max(0, of(g) || 0)))];
}

/** Upper end of the stress scale: all but a few grains lie below; one scale for all frames, so that they compare. */
function stressTop(sample) {
  if (sample.stressTop) return sample.stressTop;
  const last = sample.frame(sample.frameCount - 1);
  const sorted = Float32Array.from(last.sigmaNorm).sort();
  const high = sorted[Math.floor(0.99 * (sorted.length - 1))];
  return (sample.stressTop = Math.max(1, Math.ceil(2 * high) / 2));
}

/** Colours of all grains as bytes for the graphics card. */
export function grainColours(sample, frame, mode, theme) {
  const colour = colourings[mode].colour(sample, frame, theme);
  const known = new Map();
  const out = new Uint8Array(4 * sample.count);
  for (let g = 0; g < sample.count; ++g) {
    const name = colour(g);
    if (!known.has(name)) known.set(name, bytes(name));
    out.set(known.get(name), 4 * g);
    out[4 * g + 3] = 255;
  }
  return out;
}
