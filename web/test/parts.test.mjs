import assert from "node:assert/strict";
import { test } from "node:test";
import { zoomIdentity } from "d3-zoom";
import { inWords, named, Numbers, readWords } from "../src/declared.js";
import { evaluate, evaluateAll, namesIn } from "../src/formula.js";
import { tables } from "../src/numbers.js";
import { histogram, makeScale } from "../src/field/scale.js";
import { quantityWithError } from "../src/film/tooltip.js";
import { boundaryElement, chainWidth, segmentsOf } from "../src/packing/chains.js";
import { Camera } from "../src/camera.js";
import { Sample } from "../src/sample.js";
import { State } from "../src/state.js";
import { prefixOf, text, typeset } from "../src/text.js";

test("a value and its error end at the error's second digit", () => {
  assert.deepEqual(text.withError(0.123456, 0.02891), { value: "0.123", error: "0.029" });
  assert.deepEqual(text.withError(98.63, 6.72), { value: "98.6", error: "6.7" });
  assert.deepEqual(text.withError(1281.4, 50.2), { value: "1281", error: "50" });
  assert.deepEqual(text.withError(-1.2345, 0.01), { value: "\u22121.234", error: "0.010" });
});

test("a value without an error keeps four digits and says no error", () => {
  assert.deepEqual(text.withError(3.14159, null), { value: "3.142", error: "" });
  assert.deepEqual(text.withError(1, 7e-16), { value: "1.000", error: "" });
  assert.deepEqual(text.withError(0.333333, 3e-9), { value: "0.3333", error: "" });
  assert.deepEqual(text.withError(3.00324, 3e-6), { value: "3.0032400", error: "0.0000030" });
  assert.deepEqual(text.withError(null, null), { value: "\u2013", error: "" });
});

test("a stage without curves of its own shows those of the stage before it, or of the next", () => {
  const curves = (name) => ({ figures: { "test-curves": [name] } });
  const stages = [{ figures: {} }, curves("press"), curves("shear"), { figures: {} }];
  const snapshots = stages.map((_, stage) => ({ stage, figures: {} }));
  const shown = (snapshot, nearest, of = stages) =>
    new Sample({ stages: of, snapshots }).drawn("test-curves", { get: () => snapshot }, nearest);
  assert.deepEqual(
    [0, 1, 2, 3].map((snapshot) => shown(snapshot, true)),
    [
      { drawings: ["press"], here: null, first: 1 },
      { drawings: ["press"], here: 0, first: 1 },
      { drawings: ["shear"], here: 0, first: 2 },
      { drawings: ["shear"], here: null, first: 2 },
    ],
  );
  assert.equal(shown(0, false), null);
  assert.equal(
    shown(
      0,
      true,
      stages.map(() => ({ figures: {} })),
    ),
    null,
  );
});

test("a page opens with the last state, or where the sample failed, and shows the states of a stage alike", () => {
  const stages = [{ figures: {} }, { figures: {}, opens: 1 }],
    extents = [
      [0, 9, 0, 9],
      [0, 1, 0, 1],
      [0, 3, -1, 1],
      [0, 2, 0, 2],
    ];
  const snapshots = extents.map((extent, k) => ({ stage: Math.min(k, 1), extent }));
  const sample = new Sample({ stages, snapshots });
  assert.equal(sample.opening, 2);
  assert.deepEqual(sample.extent(1), { left: -0.24, right: 3.24, bottom: -1.24, top: 1.24 });
  assert.deepEqual(sample.extent(0), { left: 0, right: 9, bottom: 0, top: 9 });
  assert.equal(new Sample({ stages: [stages[0], { figures: {} }], snapshots }).opening, 3);
});

test("quantities take the prefix that suits them", () => {
  assert.equal(text.quantity(50000, "N"), "50.0\u202fkN");
  assert.equal(text.quantity(-1.876e6, "Pa"), "\u22121.88\u202fMPa");
  assert.equal(text.quantity(0.02, "m", 1), "20\u202fmm");
  assert.equal(text.quantity(0, "N"), "0\u202fN");
  assert.equal(text.quantity(12, "%"), "12.0\u202f%");
  assert.deepEqual(prefixOf(999.9, "N"), { factor: 1000, prefix: "k", unit: "kN" });
});

test("very large and very small numbers are written with a power of ten", () => {
  assert.equal(text.number(1.5e-7, 2), "1.5\u00b710\u207b\u2077");
  assert.equal(text.number(2.5e6, 2), "2.5\u00b710\u2076");
});

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

test("formulas of the program are formed as it forms them", () => {
  const at = { xx: 3, yy: 1, xy: 1 };
  assert.equal(
    evaluate("xx yy + 2 /", (name) => at[name]),
    2,
  );
  assert.equal(
    evaluate("xx yy - 2 / xy hypot", (name) => at[name]),
    Math.SQRT2,
  );
  assert.ok(Math.abs(evaluate("2 xy * xx yy - atan2 90 * pi /", (name) => at[name]) - 22.5) < 1e-12);
  const all = { a: Float32Array.of(3, 6), b: Float32Array.of(4, 8) };
  assert.deepEqual([...evaluateAll("a b hypot 1 -", 2, (name) => all[name])], [4, 9]);
  assert.deepEqual(namesIn("2 xy * xx yy - atan2 90 * pi /"), ["xy", "xx", "yy"]);
});

/** As the program's page has them. */
const words = {
  S_m: ["S_{m}", ""],
  dx: ["node spacing", ""],
  pressure: ["pressure", "p"],
  sigma_yy: ["\u03c3_{yy}", ""],
  stress: ["stress", "\u03c3"],
  modulus: ["apparent modulus", "E"],
};

test("keys of numbers become the words that the data hold, or their own, without the unit that is declared", () => {
  readWords(words);
  assert.deepEqual(named("mean_Pa", "Pa"), { name: "mean", symbol: "" });
  assert.deepEqual(named("toughness_Pa_m0.5", "Pa m^0.5"), { name: "toughness", symbol: "" });
  assert.deepEqual(named("work_J_per_m", "J/m"), { name: "work", symbol: "" });
  assert.deepEqual(named("lost_area_m2", "m^2"), { name: "lost area", symbol: "" });
  assert.deepEqual(named("S_m"), { name: "S_{m}", symbol: "" });
  assert.deepEqual(named("dx_m", "m"), { name: "node spacing", symbol: "" });
  assert.deepEqual(named("pressure_Pa", "Pa"), { name: "pressure", symbol: "p" });
  assert.deepEqual(named("POM-ANY"), { name: "POM\u2013any", symbol: "" });
  assert.deepEqual(
    named("thinnest_neck_m"),
    { name: "thinnest neck m", symbol: "" },
    "a unit is declared, never guessed",
  );
});

test("units are printed as in books", () => {
  assert.deepEqual(["kg/m^3", "deg", "m^2", "Pa m^0.5", "m/s", ""].map(typeset), [
    "kg/m\u00b3",
    "\u00b0",
    "m\u00b2",
    "Pa\u2009m^{1/2}",
    "m/s",
    "",
  ]);
});

test("what is said of several sets alike stands in one table, and what is drawn, or was shown, is left out", () => {
  readWords(words);
  const of = (count) => ({
    count,
    tail: { slope: { value: 5, error: 1 }, low: 2 },
    histogram: { low: -1, width: 0.05 },
  });
  const numbers = new Numbers(
    {
      modulus_Pa: 1,
      poisson: 0.3,
      stress: { nodes: 9, sigma_yy: { sets: { all: of(9), matrix: of(3), large: of(6) } } },
      load: { stiffness_Pa: { matrix: 1, grain: 2 }, "toughness_Pa_m0.5": { matrix: 1, grain: 2 } },
      notes: ["a sentence"],
    },
    { modulus_Pa: ["Pa", "Young's modulus"] },
    ["histogram", "notes"],
  );
  assert.deepEqual(
    numbers.row("poisson").map(({ value }) => value),
    [0.3],
  );
  assert.deepEqual(
    tables("", numbers).map(({ title, names, sets }) => [title, names, sets?.map(([name]) => name) ?? null]),
    [
      ["Result", ["modulus_Pa"], null],
      ["Stress", ["nodes"], null],
      ["Stress, \u03c3_{yy}", ["count"], ["all", "matrix", "large"]],
      ["Stress, \u03c3_{yy}, tail", ["slope", "low"], ["all", "matrix", "large"]],
      ["Load", ["matrix", "grain"], ["stiffness_Pa", "toughness_Pa_m0.5"]],
    ],
  );
  assert.deepEqual(numbers.row("modulus_Pa"), [
    { name: "apparent modulus", symbol: "E", unit: "Pa", sentence: "Young's modulus", value: 1 },
  ]);
});

test("names with dots are found, and a tensor has a row a component", () => {
  readWords(words);
  const numbers = new Numbers(
    {
      quantiles: { "0.01 %": 3 },
      stress: {
        value: [
          [1, 2],
          [2, 4],
        ],
        error: [
          [0.1, 0.2],
          [0.2, 0.4],
        ],
      },
    },
    { stress: ["Pa", "Stress"], "quantiles.0.01 %": ["Pa", "Quantile"] },
  );
  assert.deepEqual(
    numbers
      .in("quantiles")
      .row("0.01 %")
      .map(({ value, unit }) => [value, unit]),
    [[3, "Pa"]],
  );
  assert.deepEqual(
    numbers.row("stress").map(({ name, value, unit }) => [name, value.value, value.error, unit]),
    [
      ["\u03c3_{xx}", 1, 0.1, "Pa"],
      ["\u03c3_{yy}", 4, 0.4, "Pa"],
      ["\u03c3_{xy}", 2, 0.2, "Pa"],
    ],
  );
});

test("a number is written with its error and the prefix that suits it", () => {
  assert.deepEqual(inWords({ value: 1234, error: 56 }, "N"), { value: "1.234", error: "0.056", unit: "kN" });
  assert.deepEqual(inWords(7, ""), { value: "7", error: "", unit: "" });
  assert.deepEqual(inWords(true, ""), { value: "yes", error: "", unit: "" });
  assert.deepEqual(inWords({ value: 5, error: 1 }, "Pa", 5000), { value: "0.0050", error: "0.0010", unit: "kPa" });
});

test("a quantity and its error share the prefix of the larger one", () => {
  assert.equal(quantityWithError(3600, 170, "N"), "3.60 \u00b1 0.17\u202fkN");
  assert.equal(quantityWithError(0, 120, "N"), "0 \u00b1 120\u202fN");
  assert.equal(quantityWithError(-1e5, 0, "Pa"), "\u2212100\u202fkPa");
});

test("a histogram counts what lies within its scale, and evenly coded values make no comb", () => {
  const values = Float32Array.from({ length: 2001 }, (_, k) => Math.round((k - 1000) / 8) / 125),
    order = values.sort();
  const counts = histogram(order, makeScale(order, { around: "ends", symlog: false, clip: 0, mean: 0 }), 140);
  assert.ok(Math.abs(counts.reduce((a, b) => a + b, 0) - 2001) < 12);
  for (const n of counts.slice(2, -2)) assert.ok(Math.abs(n - 2001 / 140) < 0.2 * (2001 / 140), `${n}`);
});
