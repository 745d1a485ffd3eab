import assert from "node:assert/strict";
import { test } from "node:test";
import { zoomIdentity } from "d3-zoom";
import { readDrawn, widthOfForce } from "../src/drawn.js";
import { boundaryElement, chainWidth, segmentsOf } from "../src/packing/chains.js";
import { scaleOf } from "../src/packing/colouring.js";
import { knownQuantities, valuesOf } from "../src/quantities.js";
import { pairsSeen } from "../src/packing/strokes.js";
import { Camera } from "../src/camera.js";
import { Sample } from "../src/sample.js";
import { State } from "../src/state.js";
import { units } from "./program.mjs";

readDrawn({ chain: { width: 0.25, widest: 1 }, units });

function camera() {
  const c = new Camera();
  c.resize(600, 400);
  c.fit({ left: 0, right: 0.35, bottom: 0.01, top: 0.36 }, 20);
  return c;
}

test("a fitted box stands in the middle with its margin", () => {
  const c = camera();
  const [, top] = c.toScreen(0, 0.36),
    [, bottom] = c.toScreen(0, 0.01);
  assert.ok(Math.abs(top - 20) < 1e-9 && Math.abs(bottom - 380) < 1e-9);
});

test("screen and plane are each other's inverse", () => {
  const [x, y] = camera().toWorld(...camera().toScreen(0.123, 0.045));
  assert.ok(Math.abs(x - 0.123) < 1e-12 && Math.abs(y - 0.045) < 1e-12);
});

test("zooming keeps the point under the pointer", () => {
  const c = camera(),
    before = c.toWorld(137, 88);
  c.follow(zoomIdentity.translate(137, 88).scale(3.7).translate(-137, -88));
  const after = c.toWorld(137, 88);
  assert.ok(Math.hypot(after[0] - before[0], after[1] - before[1]) < 1e-12);
  assert.ok(Math.abs(c.scale / c.whole.scale - 3.7) < 1e-12);
});

test("a camera and its transform say the same, whatever the picture's size became", () => {
  const c = camera(),
    place = c.toScreen(0.1, 0.2);
  c.show({ left: 0.05, right: 0.15, bottom: 0.15, top: 0.25 }, 10);
  const [x, y] = c.transform.apply(place),
    wanted = c.toScreen(0.1, 0.2);
  assert.ok(Math.hypot(x - wanted[0], y - wanted[1]) < 1e-9);
  c.resize(500, 450);
  const middle = [c.x, c.y],
    { scale } = c;
  c.follow(c.transform);
  assert.ok(Math.abs(c.scale - scale) < 1e-9 * scale && Math.hypot(c.x - middle[0], c.y - middle[1]) < 1e-12);
});

test("a state tells only those who watch what changed", () => {
  const state = new State({ a: 1, b: 2 }),
    told = [];
  state.watch(["a"], () => told.push("a"));
  state.watch(["b"], () => told.push("b"));
  state.set({ a: 1, b: 3 });
  assert.deepEqual(told, ["b"]);
});

/** Two grains at the left and the right edge of a cell 1 m wide that touch through its periodic side, and one at a
    wall. */
function cell(periodic) {
  const sample = { count: 2, meanRadius: 0.1, box: () => ({ left: 0, right: 1, bottom: 0, top: 1 }) };
  const snapshot = {
    x: [0.05, 0.95],
    y: [0.5, 0.5],
    meanForce: 2,
    contacts: { i: [0, 1], j: [1, 2 + 1], fn: [4, 2] },
    domain: {
      periodic: [periodic, false],
      tilt: 0,
      walls: [{ position: 0 }, { position: 1 }, { position: 0 }, { position: 1 }],
    },
  };
  return { sample, snapshot };
}

const near = (a, b) => a.forEach((v, k) => assert.ok(Math.abs(v - b[k]) < 1e-12, `${a} is not ${b}`));

test("a chain through a periodic side is drawn at both sides, by the nearest image", () => {
  const { sample, snapshot } = cell(true);
  const [first, second, ...more] = segmentsOf(sample, snapshot, 0);
  near(first, [0.05, 0.5, -0.05, 0.5]);
  near(second, [1.05, 0.5, 0.95, 0.5]);
  assert.equal(more.length, 0);
});

test("without periodic sides a chain goes from centre to centre", () => {
  const { sample, snapshot } = cell(false);
  near(segmentsOf(sample, snapshot, 0)[0], [0.05, 0.5, 0.95, 0.5]);
});

test("a chain to a wall is level and its round end touches the wall", () => {
  const { sample, snapshot } = cell(false);
  near(segmentsOf(sample, snapshot, 1)[0], [0.95, 0.5, 1 - chainWidth(sample, snapshot, 2) / 2, 0.5]);
});

test("a chain to a boundary ends where the grain touches it", () => {
  const { sample, snapshot } = cell(false);
  snapshot.boundaries = [
    { name: "gate", closed: false, x: [0, 1], y: [0, 0] },
    { name: "drum", closed: true, x: [0, 1, 1], y: [0.6, 0.6, 2] },
  ];
  const ends = (element, at) => {
    snapshot.contacts.j[1] = 2 + 4 + element;
    near(segmentsOf(sample, snapshot, 1)[0], [0.95, 0.5, ...at]);
  };
  ends(1, [0.95, 0]);
  ends(2, [1, 0]);
  ends(4 + 1, [0.95, 0.6]);
  ends(4 + 4, [1, 2]);
  ends(4 + 5, [
    0.95 + (1.4 * (1.4 * 0.95 - 0.5 + 0.6) * -1) / (1 + 1.4 * 1.4),
    0.5 + (1.4 * 0.95 - 0.5 + 0.6) / (1 + 1.4 * 1.4),
  ]);
  assert.equal(boundaryElement(snapshot, 4 + 5).boundary.name, "drum");
});

test("a chain to a boundary goes to the nearest image through a periodic side, and is drawn at both", () => {
  const { sample, snapshot } = cell(true);
  snapshot.boundaries = [
    { name: "paddle", closed: false, x: [1.02, 1.02], y: [0, 1] },
    { name: "floor", closed: false, x: [0.1, 0.98], y: [0.4, 0.4] },
  ];
  const ends = (grain, element, expected) => {
    Object.assign(snapshot.contacts, { i: [grain], j: [2 + 4 + element], fn: [2] });
    const segments = segmentsOf(sample, snapshot, 0);
    assert.equal(segments.length, expected.length);
    expected.forEach((segment, k) => near(segments[k], segment));
  };
  ends(0, 1, [
    [0.05, 0.5, 0.02, 0.5],
    [1.05, 0.5, 1.02, 0.5],
  ]);
  ends(1, 1, [[0.95, 0.5, 1.02, 0.5]]);
  ends(1, 4 + 1, [[0.95, 0.5, 0.95, 0.4]]);
  ends(0, 4 + 2, [
    [0.05, 0.5, -0.02, 0.4],
    [1.05, 0.5, 0.98, 0.4],
  ]);
});

test("the width of a chain is proportional to its force", () => {
  const { sample, snapshot } = cell(false);
  assert.ok(Math.abs(chainWidth(sample, snapshot, 4) - 2 * chainWidth(sample, snapshot, 2)) < 1e-15);
});

test("forces are as wide as the program says, up to the widest", () => {
  assert.equal(widthOfForce(2, 1, 0.5), 0.25);
  assert.equal(widthOfForce(1e3, 1, 0.5), 0.5);
  assert.equal(widthOfForce(0, 0, 0.5), 0, "where nothing pushes");
});

test("of pairs those that a periodic side parts, or of which a grain is missing, are not seen", () => {
  const sample = { box: () => ({ left: 0, right: 1, bottom: 0, top: 1 }), radius: [0.1, 0.2, 0.1, 0.1] };
  const seen = pairsSeen(sample, { x: [0.1, 0.4, 0.9, NaN], y: [0.5, 0.9, 0.5, NaN] }, { i: [0, 0, 1], j: [2, 1, 3] });
  assert.deepEqual(
    seen.map(({ pair, ri, rj }) => [pair, ri, rj]),
    [[1, 0.1, 0.2]],
  );
  assert.ok(Math.abs(seen[0].length - 0.5) < 1e-12);
});

test("how far grains went and turned is read, and called, as the program tells it; 0 where it does not", () => {
  const state = {
    stage: 0,
    x: [0, 9],
    y: [0, 0],
    angle: [0, 7],
    domain: { walls: [] },
    contacts: { i: [], j: [] },
    force_scale: { mean: 0, tension: 0 },
  };
  const quantities = {
    displacement: ["Displacement since the first state", "|u|", "m", ""],
    rotation: ["Rotation since the first state", "\u03b8", "rad", ""],
  };
  const sample = new Sample({
    quantities,
    stages: [{ figures: {} }],
    grains: { count: 2, id: [1, 2], radius: [1, 1], material: [0, 0], zone: [0, 0] },
    snapshots: [state, { ...state, displacement: [3, 0], rotation: [0.5, -0.25] }],
  });
  const at = (name, k) => [...valuesOf(name, sample, sample.snapshot(k))];
  assert.deepEqual([at("displacement", 0), at("rotation", 0)], [
    [0, 0],
    [0, 0],
  ]);
  assert.deepEqual([at("displacement", 1), at("rotation", 1)], [
    [3, 0],
    [0.5, -0.25],
  ]);
  assert.deepEqual(
    knownQuantities(sample).map(([, { label }]) => label),
    Object.values(quantities).map(([label]) => label),
  );
  assert.equal(scaleOf(sample, new State({ colour: "rotation" })).title, "Rotation since the first state");
});
