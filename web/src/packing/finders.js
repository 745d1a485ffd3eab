import { evaluateAll } from "../formula.js";
import { aboutQuantity } from "../quantities.js";

/** How the page finds the numbers of every grain of a packing (quantities.js). */
export const finders = {
  x: { find: (sample, snapshot) => snapshot.x },
  y: { find: (sample, snapshot) => snapshot.y },
  size: { find: (sample) => sample.radius.map((r) => 2 * r) },
  coordination: { find: (sample, snapshot) => snapshot.coordination },
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

/** As the program says that it is formed of other numbers of every grain. */
const formed = (name, sample, parts) =>
  evaluateAll(aboutQuantity(name, sample).formula, sample.count, (part) => parts[part]);

/** Whether there is a state before another. */
function hasSeveral(sample) {
  return sample.snapshotCount > 1;
}

/** In any of the states. */
function has(name) {
  return (sample) => sample.about.snapshots.some((snapshot) => snapshot[name]);
}

