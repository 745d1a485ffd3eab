/** Numbers of the grains of a sample: `sample.finders` says how the page finds those of every grain in a state, by
    name: `find(sample, snapshot)` = array by grain, `when(sample)` = is it known (always unless given). Labels, symbols
    and units are the program's (`quantities` of the document), by the same names. Colours, the table, the scatter and
    what the pointer tells are made from both. */

/** What the program says of a quantity: { label, symbol, unit, scale }, the unit in SI; empty: it has none. */
export function aboutQuantity(name, sample) {
  const [label, symbol, unit, formula, scale] = sample.about.quantities[name];
  return { label, symbol, unit, formula, scale };
}

export const isKnown = (name, sample) => sample.finders[name]?.when?.(sample) ?? true;

/** The values of a quantity in a state, kept with it. */
export function valuesOf(name, sample, snapshot) {
  snapshot.values ??= {};
  return (snapshot.values[name] ??= sample.finders[name].find(sample, snapshot));
}

/** Those that are known of a sample, in the program's order: [[name, { label, symbol, unit }]]. */
export const knownQuantities = (sample) =>
  Object.keys(sample.about.quantities)
    .filter((name) => sample.finders[name] && isKnown(name, sample))
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
