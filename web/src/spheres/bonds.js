import { ways } from "../drawn.js";
import { between } from "./chains.js";

const thin = 0.16, // radius of a bond that holds over the mean radius of the spheres
  crack = 0.4; // of the ball where one broke

/** Bonds that hold as rods from centre to centre, and a ball where one broke, as lines of force are: { ends, radius,
    kind }. */
export function bondsOf({ state: { bonds, balls, container, middle }, meanRadius }) {
  const ends = [],
    radius = [],
    kind = [];
  const at = (g) => [0, 1, 2].map((axis) => balls[4 * g + axis]);
  const add = (line, share, name) => {
    ends.push(...line);
    radius.push(share * meanRadius);
    kind.push(name);
  };
  bonds.broken.forEach((broken, b) => {
    if (broken === 0)
      for (const line of between(at(bonds.i[b]), at(bonds.j[b]), container)) add(line, thin, "bond");
    else {
      const place = [bonds.x[b], bonds.y[b], bonds.z[b]].map((along, axis) => along - middle[axis]);
      add([...place, ...place], crack, ways()[broken - 1]);
    }
  });
  return { ends: new Float32Array(ends), radius: new Float32Array(radius), kind };
}

/** Several such lists as one. */
export const together = (lists) => ({
  ends: joined(lists.map(({ ends }) => ends)),
  radius: joined(lists.map(({ radius }) => radius)),
  kind: lists.flatMap(({ kind }) => kind),
});

function joined(arrays) {
  const all = new Float32Array(arrays.reduce((count, array) => count + array.length, 0));
  arrays.reduce((from, array) => (all.set(array, from), from + array.length), 0);
  return all;
}
