/** What is known of every grain in a state. A member gives: `label` in words, `symbol`, `find(sample, snapshot)` = array by grain, `like` = the array of
    the document whose unit it has, where it has one, `when(sample)` = is it known (always unless given). Colours, the table, the scatter and what the pointer tells are made from these;
    a new one is one more row. */
export const quantities = {
  x: { label: "Position along x", symbol: "x", like: "x", find: (sample, snapshot) => snapshot.x },
  y: { label: "Position along y", symbol: "y", like: "y", find: (sample, snapshot) => snapshot.y },
  size: { label: "Diameter", symbol: "d", like: "radius", find: (sample) => sample.radius.map((r) => 2 * r) },
  coordination: {
    label: "Contacts",
    symbol: "z",
    find: (sample, snapshot) => byGrain(sample, (g) => sample.coordination(snapshot, g)),
  },
  pressure: {
    label: "Pressure of grains",
    symbol: "p",
    like: "pressure",
    find: (sample, snapshot) => snapshot.pressure,
  },
  deviator: {
    label: "Deviator of grains",
    symbol: "q",
    like: "deviator",
    when: has("deviator"),
    find: (sample, snapshot) => snapshot.deviator,
  },
  stress: { label: "Stress over its mean", symbol: "\u03c3_{norm}", find: (sample, snapshot) => snapshot.sigmaNorm },
  friction: {
    label: "Mobilised friction, mean |F_{t}|/F_{n}",
    symbol: "|F_{t}|/F_{n}",
    unit: "",
    when: (sample) => sample.snapshot(sample.snapshotCount - 1).contacts.ft?.some((force) => force !== 0),
    find: mobilisations,
  },
  displacement: {
    label: "Displacement in the stage",
    symbol: "|u|",
    like: "x",
    when: (sample) => sample.snapshotCount > 1,
    find: (sample, snapshot) => displacements(sample, snapshot).map(([ux, uy]) => Math.hypot(ux, uy)),
  },
  rotation: {
    label: "Rotation in the stage",
    symbol: "\u03b8",
    like: "angle",
    when: (sample) => sample.snapshotCount > 1,
    find: (sample, snapshot) => snapshot.angle.map((angle, g) => angle - startOf(sample, snapshot).angle[g]),
  },
  speed: {
    label: "Velocity",
    symbol: "|v|",
    like: "vx",
    when: has("vx"),
    find: (sample, snapshot) => byGrain(sample, (g) => Math.hypot(snapshot.vx[g], snapshot.vy[g])),
  },
  vx: {
    label: "Velocity along x",
    symbol: "v_{x}",
    like: "vx",
    when: has("vx"),
    find: (sample, snapshot) => snapshot.vx,
  },
  vy: {
    label: "Velocity along y",
    symbol: "v_{y}",
    like: "vy",
    when: has("vx"),
    find: (sample, snapshot) => snapshot.vy,
  },
  spin: {
    label: "Angular velocity",
    symbol: "\u03c9",
    like: "omega",
    when: has("omega"),
    find: (sample, snapshot) => snapshot.omega,
  },
};

/** The values of a quantity in a state, kept with it. */
export function valuesOf(name, sample, snapshot) {
  snapshot.values ??= {};
  return (snapshot.values[name] ??= quantities[name].find(sample, snapshot));
}

/** Its SI unit; empty: it has none. */
export const unitOf = (name, sample) => (quantities[name].like ? sample.unitOf(quantities[name].like) : "");

/** Those that are known of a sample: [[name, quantity]]. */
export const knownQuantities = (sample) =>
  Object.entries(quantities).filter(([, quantity]) => quantity.when?.(sample) ?? true);

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

/** In any of the states. */
function has(name) {
  return (sample) => sample.about.snapshots.some((snapshot) => snapshot[name]);
}

const byGrain = (sample, of) => Float64Array.from({ length: sample.count }, (_, g) => of(g));

const startOf = (sample, snapshot) =>
  sample.snapshot(sample.about.snapshots.findIndex(({ stage }) => stage === snapshot.stage));

/** Ways since the first state of the snapshot's stage, m; over periodic sides the shorter one. */
export function displacements(sample, snapshot) {
  const start = startOf(sample, snapshot),
    { walls } = snapshot.domain;
  const width = snapshot.domain.periodic[0] ? walls[1].position - walls[0].position : Infinity;
  const height = snapshot.domain.periodic[1] ? walls[3].position - walls[2].position : Infinity;
  const shorter = (d, size) => (size < Infinity ? d - size * Math.round(d / size) : d);
  return Array.from(snapshot.x, (x, g) => {
    const up = snapshot.y[g] - start.y[g],
      rows = height < Infinity ? Math.round(up / height) : 0;
    return [shorter(x - start.x[g] - rows * (snapshot.domain.tilt ?? 0), width), shorter(up, height)];
  });
}

function mobilisations(sample, snapshot) {
  const { start, list } = sample.contactsByGrain(snapshot),
    { fn, ft } = snapshot.contacts;
  return byGrain(sample, (g) => {
    let sum = 0,
      count = 0;
    for (let c = start[g]; c < start[g + 1]; ++c)
      if (fn[list[c]] > 0) ((sum += Math.abs(ft[list[c]]) / fn[list[c]]), ++count);
    return count > 0 ? sum / count : 0;
  });
}
