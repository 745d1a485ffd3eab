import assert from "node:assert/strict";
import { test } from "node:test";
import { inWords, named, Numbers, readWords } from "../src/declared.js";
import { readDrawn } from "../src/drawn.js";
import { evaluate, evaluateAll, namesIn } from "../src/formula.js";
import { tables } from "../src/numbers.js";
import { histogram, makeScale } from "../src/field/scale.js";
import { quantityWithError } from "../src/film/tooltip.js";
import { Sample } from "../src/sample.js";
import { factorOf, prefixOf, text, typeset } from "../src/text.js";
import { units } from "./program.mjs";

readDrawn({ units });

test("a value and its error end at the error's second digit", () => {
  assert.deepEqual(text.withError(0.123456, 0.02891), { value: "0.123", error: "0.029" });
  assert.deepEqual(text.withError(98.63, 6.72), { value: "98.6", error: "6.7" });
  assert.deepEqual(text.withError(1281.4, 50.2), { value: "1281", error: "50" });
  assert.deepEqual(text.withError(12.3456, 0.0996), { value: "12.35", error: "0.10" });
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

test("a unit with a prefix is told in the one without, whatever prefix it has", () => {
  assert.deepEqual(["mm", "m", "\u00b5m", "kPa", "MN", "%", "deg", undefined].map(factorOf), [
    1e-3, 1, 1e-6, 1e3, 1e6, 1, 1, 1,
  ]);
  for (const size of [3e-7, 0.02, 4, 5e7])
    for (const unit of ["m", "Pa", "Pa m^0.5"]) {
      const { factor, unit: prefixed } = prefixOf(size, unit);
      assert.equal(factorOf(prefixed), factor, prefixed);
    }
});

test("very large and very small numbers are written with a power of ten", () => {
  assert.equal(text.number(1.5e-7, 2), "1.5\u00b710\u207b\u2077");
  assert.equal(text.number(2.5e6, 2), "2.5\u00b710\u2076");
});

test("a scale ends where the program says, or else where the share that the reader chose is beyond", () => {
  const order = Float64Array.from({ length: 101 }, (_, k) => k),
    how = { around: "ends", symlog: false, clip: 0.05, mean: 0 };
  const { low, high } = makeScale(order, how),
    told = makeScale(order, { ...how, ends: [2, 90] });
  assert.deepEqual([low, high], [5, 95]);
  assert.deepEqual([told.low, told.high], [2, 90]);
  const centred = makeScale(order, { ...how, around: "zero", ends: [-10, 90] });
  assert.deepEqual([centred.low, centred.high], [-90, 90]);
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
