import { evaluateAll } from "../formula.js";

/** How the page finds the numbers of every grain in a state: `find(sample, snapshot)` = array by grain, `when(sample)`
    = is it known (always unless given). Labels, symbols and units are the program's (`quantities` of the document), by
    the same names. Colours, the table, the scatter and what the pointer tells are made from both. */
const finders = {
  x: { find: (sample, snapshot) => snapshot.x },
  y: { find: (sample, snapshot) => snapshot.y },
  size: { find: (sample) => sample.radius.map((r) => 2 * r) },
  coordination: { find: (sample, snapshot) => byGrain(sample, (g) => sample.coordination(snapshot, g)) },
  pressure: { find: (sample, snapshot) => snapshot.pressure },
  deviator: { when: has("deviator"), find: (sample, snapshot) => snapshot.deviator },
  stress: { find: (sample, snapshot) => snapshot.sigmaNorm },
  friction: { when: has("friction"), find: (sample, snapshot) => snapshot.friction ?? new Float32Array(sample.count) },
  displacement: { when: hasSeveral, find: (sample, snapshot) => snapshot.displacement },
  rotation: { when: hasSeveral, find: (sample, snapshot) => snapshot.rotation },
  speed: {
    when: has("vx"),
    find: (sample, snapshot) => formed("speed", sample, snapshot),
  },
  vx: { when: has("vx"), find: (sample, snapshot) => snapshot.vx },
  vy: { when: has("vx"), find: (sample, snapshot) => snapshot.vy },
  spin: { when: has("omega"), find: (sample, snapshot) => snapshot.omega },
};

/** What the program says of a quantity: { label, symbol, unit }, the unit in SI; empty: it has none. */
export function aboutQuantity(name, sample) {
  const [label, symbol, unit, formula] = sample.about.quantities[name];
  return { label, symbol, unit, formula };
}

/** As the program says that it is formed of other numbers of every grain. */
const formed = (name, sample, parts) =>
  evaluateAll(aboutQuantity(name, sample).formula, sample.count, (part) => parts[part]);

export const isKnown = (name, sample) => finders[name]?.when?.(sample) ?? true;

/** The values of a quantity in a state, kept with it. */
export function valuesOf(name, sample, snapshot) {
  snapshot.values ??= {};
  return (snapshot.values[name] ??= finders[name].find(sample, snapshot));
}

/** Those that are known of a sample, in the program's order: [[name, { label, symbol, unit }]]. */
export const knownQuantities = (sample) =>
  Object.keys(sample.about.quantities)
    .filter((name) => finders[name] && isKnown(name, sample))
    .map((name) => [name, aboutQuantity(name, sample)]);

/** The value below which all but a few grains of the last state lie: one for all states, so that they compare. */
export function topOf(name, sample, share = 0.99) {
  const tops = (sample.tops ??= new Map());
  if (!tops.has(name)) {
    const sorted = Float64Array.from(valuesOf(name, sample, sample.snapshot(sample.snapshotCount - 1)), Math.abs)
      .filter(Number.isFinite)
      .sort();
    tops.set(name, sorted[Math.floor(share * (sorted.length - 1))] ?? 0);
  }
  return tops.get(name);
}

/** Whether there is a state before another. */
function hasSeveral(sample) {
  return sample.snapshotCount > 1;
}

/** In any of the states. */
function has(name) {
  return (sample) => sample.about.snapshots.some((snapshot) => snapshot[name]);
}

const byGrain = (sample, of) => Float64Array.from({ length: sample.count }, (_, g) => of(g));
