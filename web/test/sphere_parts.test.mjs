import assert from "node:assert/strict";
import { test } from "node:test";
import { kindOfForce, readDrawn } from "../src/drawn.js";
import { directionAt } from "../src/figures/turned_sphere.js";
import { dot, frameOf } from "../src/space/frame.js";
import { bondsOf, together } from "../src/spheres/bonds.js";
import { edgesOf } from "../src/spheres/boundaries.js";
import { between } from "../src/spheres/chains.js";
import { scaleOf } from "../src/spheres/paint.js";
import { SphereResult } from "../src/spheres/result.js";
import { seenSphere } from "../src/spheres/seen.js";
import { State } from "../src/state.js";
import { units } from "./program.mjs";

readDrawn({ breaks: ["", "tension", "bending", "shear", "twisting"], units });

const close = (a, b) => a.length === b.length && a.every((v, k) => Math.abs(v - b[k]) < 1e-12);

test("with y upright a viewer in front sees x to the right and y upwards", () => {
  const { right, up, towards } = frameOf(0, 0, 1);
  assert.ok(close(right, [1, 0, 0]) && close(up, [0, 1, 0]) && close(towards, [0, 0, 1]));
  const { right: r, up: u, towards: t } = frameOf(31, 17, 1);
  const cross = [r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]];
  assert.ok(close(cross, t), "right-handed");
  assert.ok(Math.abs(dot(r, u)) < 1e-12);
});

test("a line across a side of a periodic cell is half a line at both spheres, shifted in a sheared cell", () => {
  const cell = { size: [10, 8, 6], periodic: [true, true, false], tilt: 1.5 };
  assert.deepEqual(between([1, 0, 0], [2, 0, 0], cell), [[1, 0, 0, 2, 0, 0]]);
  const [a, b] = between([-4.5, 0, 0], [4.5, 0, 0], cell);
  assert.ok(close(a, [-4.5, 0, 0, -5, 0, 0]) && close(b, [4.5, 0, 0, 5, 0, 0]));
  // Above the cell lies its image 1.5 to the right: from y = 3.5 upwards to y = -3.5 of the image.
  const [c, d] = between([0, 3.5, 0], [-1.5, -3.5, 0], cell);
  assert.ok(close(c, [0, 3.5, 0, 0, 4, 0]) && close(d, [-1.5, -3.5, 0, -1.5, -4, 0]));
  assert.equal(between([0, 0, -2.9], [0, 0, 2.9], cell).length, 1, "z is not periodic");
});

test("a line of sight meets the sphere in front, unless that is cut away", () => {
  const balls = new Float32Array([0, 0, 0, 1, 0.5, 0, 1.5, 1, 0, 3, 0, 1]),
    all = [Infinity, Infinity, Infinity],
    front = frameOf(0, 0, 1);
  assert.equal(seenSphere(front, [0, 0], balls, all), 1);
  assert.equal(seenSphere(front, [-0.7, 0], balls, all), 0);
  assert.equal(seenSphere(front, [0, 0], balls, [Infinity, Infinity, 1]), 0);
  assert.equal(seenSphere(front, [1.6, 0], balls, all), null);
  assert.equal(seenSphere(frameOf(180, 0, 1), [0, 0], balls, all), 0, "from behind");
});

test("a bond that holds is a rod between its spheres, one that broke a ball where it did", () => {
  const container = { corner: [1, 1, 1], size: [4, 4, 4], periodic: [true, false, false], tilt: 0 },
    balls = new Float32Array([-1, 0, 0, 0.5, 0, 0, 0, 0.5, 1.75, 0, 0, 0.5]),
    bonds = { i: [0, 0, 1], j: [1, 2, 2], broken: [0, 0, 4], x: [0, 0, 4], y: [0, 0, 3], z: [0, 0, 3.5] };
  const { ends, radius, kind } = bondsOf({ state: { bonds, balls, container, middle: [3, 3, 3] }, meanRadius: 0.5 });
  assert.deepEqual(kind, ["bond", "bond", "bond", "twisting"], "across the periodic side it is two halves");
  assert.deepEqual([...ends.slice(0, 6)], [-1, 0, 0, 0, 0, 0]);
  assert.deepEqual([...ends.slice(-6)], [1, 0, 0.5, 1, 0, 0.5], "from the middle of the container");
  assert.ok(radius[3] > radius[0]);
  const twice = together([
    { ends, radius, kind },
    { ends, radius, kind },
  ]);
  assert.equal(twice.ends.length, 48);
  assert.equal(twice.kind.length, 8);
});

test("of boundaries that are there the edges are lines, from the middle of the container", () => {
  const boundaries = [
      { present: false, ends: [0, 0, 0, 9, 9, 9] },
      { present: true, ends: [3, 2, 4, 4, 2, 4, 4, 2, 4, 4, 3, 4] },
    ];
  const { ends, radius, kind } = edgesOf({ state: { boundaries, middle: [3, 2, 4] }, meanRadius: 0.5 });
  assert.deepEqual([...ends], [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0]);
  assert.deepEqual(kind, ["boundary", "boundary"]);
  assert.equal(radius.length, 2);
});

test("a force above the mean is strong, one below the traces of tension pulls", () => {
  assert.deepEqual(
    [2, 0.5, -1e-4, -3].map((force) => kindOfForce(force, { mean: 1, tension: -1e-3 })),
    ["strong", "weak", "weak", "tension"],
  );
});

/** A sphere in a box whose top comes down; the page has the first and the third of three states. */
const pressed = () => {
  const box = (height) => ({ corner: [0, 0, 0], size: [2, height, 2], periodic: [false, false, false], tilt: 0 });
  const quantities = { speed: { label: "Velocity", symbol: "|v|", unit: "m/s", magnitude: true, mean: 2 } };
  const rest = { z: [1], speed: [2], materials: [{ name: "glass" }], quantities };
  return new SphereResult({
    name: "axial",
    figures: {},
    states: [
      { place: 0, container: box(4), x: [1], y: [3], z: [1] },
      { place: 2, container: box(2), x: [1], y: [1.5], radius: [0.5], material: [0], id: [7], ...rest },
    ],
  });
};

test("a state has of the last one what all have alike, and its places count from the same point", () => {
  const result = pressed();
  assert.deepEqual([...result.state.balls], [0, 0.5, 0, 0.5], "as it opens");
  result.show(0);
  assert.deepEqual([...result.state.balls], [0, 2, 0, 0.5]);
  assert.deepEqual(result.state.id, [7]);
  assert.deepEqual([...result.state.speed], [0], "of which that state knows nothing");
  assert.deepEqual(result.state.shift, [0, 1, 0]);
  assert.equal(result.place(1, 100), Infinity);
  assert.equal(result.place(1, 50), 1, "the middle of that state's container");
  assert.equal(result.reach, 1 + Math.hypot(2, 4, 2) / 2);
  assert.deepEqual([...result.order("speed")], [2], "colours of all states are those of the last");
});

test("what colours mean is what the program says of the last state, in every state", () => {
  const result = pressed();
  result.show(0);
  assert.deepEqual(result.offered, [], "which all spheres have alike");
  assert.equal(result.quantity("speed").label, "Velocity");
  assert.deepEqual(Object.keys(result.state.quantities), ["speed"]);
  assert.equal(result.written("speed", 0), "0\u202fm/s");
  const show = new State({ show: "speed", around: "mean", law: "linear", clip: "all" }),
    { mean, centre } = scaleOf(result, show);
  assert.deepEqual([mean, centre], [2, null], "a size is never centred about its mean");
});

test("of states that are left out the next one is shown", () => {
  const result = pressed(),
    at = (snapshot) => result.stepAt(new Map([["snapshot", snapshot]]));
  assert.deepEqual([at(0), at(1)], [0, 2]);
  assert.deepEqual([0, 2, 9].map((place) => result.stateAt(place)), [0, 1, 1]);
});

/** Two states of five with fields on 2 x 1 x 2 cells, coded in steps of a quarter; the second is at rest, and no grain
    is near one of its cells. */
const withFields = () => {
  const block = [],
    stored = (values) => ({ at: block.push(...values) - values.length, n: values.length, as: "u1" }),
    // Each code less what those before predict: of the first 0, of the second the first, of the third the first, ..
    coded = (residual) => ({ law: "linear", centre: 0, width: 1, levels: 4, residual: stored(residual) });
  const state = (height, fields) => ({
    fields: { low: [1, 0, 0], high: [3, height, 8], cells: [2, 1, 2], width: 0.5, ...fields },
  });
  const solid = { solid_fraction: coded([4, 2, 1, 0]) },
    motion = Object.fromEntries(["vx", "vy", "vz"].map((v) => [v, coded([8, 0, 0, 8])])),
    ends = { solid_fraction: [0.25, 0.75], speed: [0, 3.5], vx: [-2, 2] };
  const states = [
    {},
    state(4, { ends, layers: { ...solid, ...motion } }),
    {},
    {},
    state(2, { ends, layers: solid, reached: stored([1, 1, 0, 1]) }),
  ];
  const layers = {
    solid_fraction: ["Solid fraction", "\u03c6", "", "", "even"],
    speed: ["Velocity", "|v|", "m/s", "vx vy hypot vz hypot", "even"],
    vx: ["Velocity along x", "v_{x}", "m/s", "", "diverging"],
    vy: ["Velocity along y", "v_{y}", "m/s", "", "diverging"],
    vz: ["Velocity along z", "v_{z}", "m/s", "", "diverging"],
  };
  return new SphereResult({ name: "axial", figures: {}, layers, states }, new Uint8Array(block)).coarseFields();
};

test("fields are those of the state shown or of the nearest that has them, in its own container", () => {
  const fields = withFields();
  assert.deepEqual(fields.size, [2, 1, 2]);
  assert.deepEqual(fields.sides, [2, 2, 8], "as it opens: the last state");
  assert.deepEqual(
    [0, 1, 2, 3, 4].map((k) => (fields.show(k), fields.shown)),
    [1, 1, 1, 4, 4],
  );
  fields.show(0);
  assert.equal(fields.state.place(1, 0), 2);
  assert.equal(fields.state.place(0, 1), 2.5);
  assert.equal(fields.placed(2, 1), "6.00\u202fm");
  assert.equal(fields.indexOf([1, 0, 1]), 3);
});

test("fields have the values that were coded, none where no grain is near, and at rest nothing moves", () => {
  const fields = withFields();
  assert.deepEqual(
    fields.offered.map(([name]) => name),
    ["solid_fraction", "speed", "vx", "vy", "vz"],
  );
  // 4 is +2, 2 is +1, 1 is -1 and 0 is 0 quarters beyond what is predicted.
  assert.deepEqual([...fields.layer("solid_fraction").values], [0.5, 0.75, NaN, 0.5]);
  assert.deepEqual([...fields.layer("vx").values], [0, 0, NaN, 0]);
  fields.show(1);
  assert.deepEqual([...fields.layer("solid_fraction").values], [0.5, 0.75, 0.25, 0.5]);
  assert.deepEqual([...fields.layer("vx").values], [1, 1, 1, 2]);
  assert.ok(Math.abs(fields.layer("speed").values[3] - Math.hypot(2, 2, 2)) < 1e-6);
  const { low, high } = fields.layer("vx").scale;
  assert.deepEqual([low, high], [-2, 2], "as the program says");
  assert.deepEqual([fields.layer("solid_fraction").scale.low, fields.layer("speed").scale.low], [0.25, 0]);
});

test("directions of the projection are unit vectors, and equal areas of it are equal areas of the sphere", () => {
  assert.ok(close(directionAt(0, 77), [0, 1, 0]));
  assert.ok(close(directionAt(1, 0), [1, 0, 0]) && close(directionAt(1, 270), [0, 0, 1]), "z is below");
  assert.ok(close(directionAt(1, 90), [0, 0, -1]));
  for (const r of [0.2, 0.6, 0.9]) {
    const n = directionAt(r, 30);
    assert.ok(Math.abs(dot(n, n) - 1) < 1e-12);
    assert.ok(Math.abs(1 - n[1] - r * r) < 1e-12, "shares of a cap, 1 - y, and of a disk");
  }
});
