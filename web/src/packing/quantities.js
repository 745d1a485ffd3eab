/** What is known of every grain in a state. A member gives: `label` in words, `symbol`, `find(sample, frame)` = array by grain, `like` = the array of
    the document whose unit it has, where it has one, `when(sample)` = is it known (always unless given). Colours, the table, the scatter and what the pointer tells are made from these;
    a new one is one more row. */
export const quantities = {
  x: { label: "Position along x", symbol: "x", like: "x", find: (sample, frame) => frame.x },
  y: { label: "Position along y", symbol: "y", like: "y", find: (sample, frame) => frame.y },
  size: { label: "Diameter", symbol: "d", like: "radius", find: (sample) => sample.radius.map((r) => 2 * r) },
  coordination: { label: "Contacts", symbol: "z", find: (sample, frame) => byGrain(sample, (g) => sample.coordination(frame, g)) },
  pressure: { label: "Pressure of grains", symbol: "p", like: "pressure", find: (sample, frame) => frame.pressure },
  deviator: { label: "Deviator of grains", symbol: "q", like: "deviator", when: has("deviator"), find: (sample, frame) => frame.deviator },
  stress: { label: "Stress over its mean", symbol: "\u03c3_{norm}", find: (sample, frame) => frame.sigmaNorm },
  friction: {
    label: "Mobilised friction, mean |F_{t}|/F_{n}", symbol: "|F_{t}|/F_{n}", unit: "",
    when: (sample) => sample.frame(sample.frameCount - 1).contacts.ft?.some((force) => force !== 0), find: mobilisations,
  },
  displacement: {
    label: "Displacement in the stage", symbol: "|u|", like: "x", when: (sample) => sample.frameCount > 1,
    find: (sample, frame) => displacements(sample, frame).map(([ux, uy]) => Math.hypot(ux, uy)),
  },
  rotation: {
    label: "Rotation in the stage", symbol: "\u03b8", like: "angle", when: (sample) => sample.frameCount > 1,
    find: (sample, frame) => frame.angle.map((angle, g) => angle - startOf(sample, frame).angle[g]),
  },
  speed: { label: "Velocity", symbol: "|v|", like: "vx", when: has("vx"), find: (sample, frame) => byGrain(sample, (g) => Math.hypot(frame.vx[g], frame.vy[g])) },
  vx: { label: "Velocity along x", symbol: "v_{x}", like: "vx", when: has("vx"), find: (sample, frame) => frame.vx },
  vy: { label: "Velocity along y", symbol: "v_{y}", like: "vy", when: has("vx"), find: (sample, frame) => frame.vy },
  spin: { label: "Angular velocity", symbol: "\u03c9", like: "omega", when: has("omega"), find: (sample, frame) => frame.omega },
};

/** The values of a quantity in a state, kept with it. */
export function valuesOf(name, sample, frame) {
  frame.values ??= {};
  return (frame.values[name] ??= quantities[name].find(sample, frame));
}

/** Its SI unit; empty: it has none. */
export const unitOf = (name, sample) => (quantities[name].like ? sample.unitOf(quantities[name].like) : "");

/** Those that are known of a sample: [[name, quantity]]. */
export const knownQuantities = (sample) => Object.entries(quantities).filter(([, quantity]) => quantity.when?.(sample) ?? true);

/** The value below which all but a few grains of the last state lie: one for all states, so that they compare. */
export function topOf(name, sample, share = 0.99) {
  const tops = (sample.tops ??= new Map());
  if (!tops.has(name)) {
    const sorted = Float64Array.from(valuesOf(name, sample, sample.frame(sample.frameCount - 1)), Math.abs).filter(Number.isFinite).sort();
    tops.set(name, sorted[Math.floor(share * (sorted.length - 1))] ?? 0);
  }
  return tops.get(name);
}

/** In any of the states. */
function has(name) { return (sample) => sample.about.frames.some((frame) => frame[name]); }

const byGrain = (sample, of) => Float64Array.from({ length: sample.count }, (_, g) => of(g));

const startOf = (sample, frame) => sample.frame(sample.about.frames.findIndex(({ stage }) => stage === frame.stage));

/** Ways since the first state of the frame's stage, m; over periodic sides the shorter one. */
export function displacements(sample, frame) {
  const start = startOf(sample, frame), { walls } = frame.domain;
  const width = frame.domain.periodic[0] ? walls[1].position - walls[0].position : Infinity;
  const height = frame.domain.periodic[1] ? walls[3].position - walls[2].position : Infinity;
  const shorter = (d, size) => (size < Infinity ? d - size * Math.round(d / size) : d);
  return Array.from(frame.x, (x, g) => {
    const up = frame.y[g] - start.y[g], rows = height < Infinity ? Math.round(up / height) : 0;
    return [shorter(x - start.x[g] - rows * (frame.domain.tilt ?? 0), width), shorter(up, height)];
  });
}

function mobilisations(sample, frame) {
  const { start, list } = sample.contactsByGrain(frame), { fn, ft } = frame.contacts;
  return byGrain(sample, (g) => {
    let sum = 0, count = 0;
    for (let c = start[g]; c < start[g + 1]; ++c)
      if (fn[list[c]] > 0) sum += Math.abs(ft[list[c]]) / fn[list[c]], ++count;
    return count > 0 ? sum / count : 0;
  });
}
