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
  coordination: {
    label: "z",
    scale: () => ({ low: 0, high: 6, title: "Contacts of a grain", map: "size", open: true }),
    colour: (sample, frame, theme) => ramp(theme.size, (g) => sample.coordination(frame, g) / 6),
  },
  displacement: {
    label: "Displacement",
    when: (sample) => sample.frameCount > 1,
    scale: (sample) => ({ low: 0, high: 1e3 * displacementTop(sample), title: "Displacement since the first state of the stage, mm", map: "size", open: true }),
    colour: (sample, frame, theme) => {
      const way = displacements(sample, frame), top = displacementTop(sample);
      return ramp(theme.size, (g) => way[g] / top);
    },
  },
  friction: {
    label: "|F_{t}|/F_{n}",
    when: (sample) => sample.frame(sample.frameCount - 1).contacts.ft?.some((force) => force !== 0),
    scale: () => ({ low: 0, high: 0.5, title: "Mean |F_{t}|/F_{n} at the contacts of a grain", map: "size", open: true }),
    colour: (sample, frame, theme) => {
      const mobilised = mobilisations(sample, frame);
      return ramp(theme.size, (g) => mobilised[g] / 0.5);
    },
  },
  zone: {
    label: "Zone",
    when: (sample) => sample.hasZones,
    scale: () => null,
    colour: (sample, frame, theme) => (g) => (sample.zone[g] > 0 ? theme.materialLine[(sample.zone[g] + 1) % 4] : theme.weak),
  },
};

/** Ways since the first state of the frame's stage, m; over periodic sides the shorter one. */
function displacements(sample, frame) {
  const start = sample.frame(sample.about.frames.findIndex(({ stage }) => stage === frame.stage)), { walls } = frame.domain;
  const width = frame.domain.periodic[0] ? walls[1].position - walls[0].position : Infinity;
  const height = frame.domain.periodic[1] ? walls[3].position - walls[2].position : Infinity;
  const shorter = (d, size) => (size < Infinity ? d - size * Math.round(d / size) : d);
  return frame.x.map((x, g) => {
    const up = frame.y[g] - start.y[g], rows = height < Infinity ? Math.round(up / height) : 0;
    return Math.hypot(shorter(x - start.x[g] - rows * (frame.domain.tilt ?? 0), width), shorter(up, height));
  });
}

/** Upper end of the scale of displacements: all but a few grains of the last state moved less. */
function displacementTop(sample) {
  if (sample.displacementTop) return sample.displacementTop;
  const sorted = Float32Array.from(displacements(sample, sample.frame(sample.frameCount - 1))).sort();
  return (sample.displacementTop = Math.max(sorted[Math.floor(0.99 * (sorted.length - 1))], 1e-9));
}

function mobilisations(sample, frame) {
  const { start, list } = sample.contactsByGrain(frame), { fn, ft } = frame.contacts;
  return frame.x.map((_, g) => {
    let sum = 0, count = 0;
    for (let c = start[g]; c < start[g + 1]; ++c)
      if (fn[list[c]] > 0) sum += Math.abs(ft[list[c]]) / fn[list[c]], ++count;
    return count > 0 ? sum / count : 0;
  });
}

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
