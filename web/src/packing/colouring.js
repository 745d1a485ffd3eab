import { drawn } from "../drawn.js";
import { prefixOf } from "../text.js";
import { bytes, mapOfScale, materialColour } from "../theme.js";
import { aboutQuantity, isKnown, topOf, valuesOf } from "../quantities.js";
import { shareOf } from "./scale.js";

/** How far grains fade towards the background while force chains lie over them. */
export const fadeUnderChains = (mode) => (mode === "material" ? 0.5 : 0.3);

const fromZero =
  (name, least = 0) =>
  (sample) => [0, Math.max(topOf(name, sample), least)];
const bothWays =
  (name, least = 0) =>
  (sample) => [-Math.max(topOf(name, sample), least), Math.max(topOf(name, sample), least)];

/** How grains may be coloured. By a quantity: `range(sample)` = [low, high]; its name and its scale of colours are what
    the program says of it, and the reader may change range and colours. By names: `colour(sample, theme)` = function
    from a grain to a colour, and `key(sample, theme)` = [[name, colour]]. A new one is one more row. */
export const colourings = {
  material: {
    label: "Material",
    colour: (sample, theme) => (g) => materialColour(theme, sample.material[g]),
  },
  size: { range: (sample) => extent(sample.radius).map((r) => 2 * r), closed: true },
  stress: {
    range: () => [0, drawn().most_stress.grains],
  },
  pressure: { range: fromZero("pressure") },
  deviator: { range: fromZero("deviator") },
  coordination: { range: () => [0, 6] },
  displacement: { range: fromZero("displacement", 1e-9) },
  rotation: { range: bothWays("rotation", 1e-6) },
  speed: { range: fromZero("speed", 1e-12) },
  vx: { range: bothWays("vx", 1e-12) },
  vy: { range: bothWays("vy", 1e-12) },
  spin: { range: bothWays("spin", 1e-9) },
  friction: { range: () => [0, 0.5] },
  zone: {
    label: "Zone",
    when: (sample) => sample.hasZones,
    colour: (sample, theme) => (g) => (sample.zone[g] > 0 ? theme.materialLine[(sample.zone[g] + 1) % 4] : theme.weak),
    key: (sample, theme) => [
      ["outside", theme.weak],
      ["inside the region", theme.materialLine[2]],
    ],
  },
};

/** Those that a sample has: [[mode, label]]. */
export function colouringsOf(sample) {
  return Object.entries(colourings)
    .filter(([mode, { when }]) => (when ? when(sample) : isKnown(mode, sample)))
    .map(([mode, { label }]) => [mode, label ?? aboutQuantity(mode, sample).label]);
}

const decadesOfLog = 3; // below the upper end, where the lower one is no positive number

/** What the colours of a quantity mean: { low, high (SI), log, map, title, unit, factor }; null where they are names.
    What the reader chose (`scales` of the state, by mode) goes before the usual. */
export function scaleOf(sample, state, mode = state.get("colour")) {
  const { range, closed } = colourings[mode];
  if (!range) return null;
  const [least, most] = range(sample),
    chosen = state.get("scales")?.[mode] ?? {},
    { label, unit: si, scale } = aboutQuantity(mode, sample);
  const { factor, unit } = prefixOf(Math.max(Math.abs(least), Math.abs(most)), si);
  const high = chosen.high ?? most,
    log = Boolean(chosen.log) && high > 0;
  let low = chosen.low ?? least;
  if (log && !(low > 0 && low < high)) low = high / 10 ** decadesOfLog;
  return {
    low,
    high,
    log,
    map: chosen.map ?? mapOfScale[scale],
    open: !closed || chosen.high !== undefined,
    title: label,
    factor,
    unit,
  };
}

function extent(values) {
  let low = Infinity,
    high = -Infinity;
  for (const v of values) {
    if (v < low) low = v;
    if (v > high) high = v;
  }
  return [low, high];
}

/** Function from a grain to its colour; `scale` = that of the quantity (scale.js), null where colours have names. */
export function grainColour(sample, snapshot, mode, scale, theme) {
  if (!scale) return colourings[mode].colour(sample, theme);
  const values = valuesOf(mode, sample, snapshot),
    map = theme.maps[scale.map],
    table = Array.from({ length: 256 }, (_, k) => map(k / 255));
  return (g) => table[Math.round(255 * shareOf(scale, values[g]))];
}

/** Colours of all grains as bytes for the graphics card. */
export function grainColours(sample, snapshot, mode, scale, theme) {
  const colour = grainColour(sample, snapshot, mode, scale, theme);
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
