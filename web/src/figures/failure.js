import * as Plot from "@observablehq/plot";
import { brokenAt, byType, crackTypes } from "../field/cracks.js";
import { prefixOf, text } from "../text.js";
import { chart } from "./chart.js";
import { withUnit } from "./tips.js";

/** A column of the test with the prefix that suits it: { values, unit }. */
function column(result, name, like = name) {
  const values = Array.from(result.curve[name] ?? []),
    { factor, unit } = prefixOf(Math.max(...result.curve[like]), result.curve[like].unit);
  return { values: values.map((v) => v / factor), unit };
}
const hasCurve = (_, result) => result.steps > 1;
const strainAxis = { label: "strain", unit: "10\u207b\u00b3", nice: true };

function here(sample, state) {
  return Math.min(state.get("step"), sample.steps - 1);
}

export const stressStrain = {
  id: "stress-strain",
  title: "Stress and strain",
  follows: ["step"],
  caption:
    "Mean stress of the loaded row against strain, one point before each round of breaking. Dot: the step shown in the picture. A click on the curve selects a step.",
  when: hasCurve,
  draw({ sample, state, theme, width }) {
    const { values: stress, unit } = column(sample, "stress");
    const rows = Array.from(sample.curve.strain, (strain, k) => ({ x: 1e3 * strain, y: stress[k], k }));
    const line = [{ x: 0, y: 0 }, ...rows]; // straight until the first bond breaks
    const svg = chart(theme, {
      width,
      height: 262,
      x: strainAxis,
      y: { label: "stress", unit, zero: true },
      tips: {
        points: rows,
        by: "both",
        reach: Infinity,
        lines: [
          ["step", ({ k }) => text.count(k + 1)],
          ["strain", ({ x }) => withUnit(x, strainAxis.unit)],
          ["stress", ({ y }) => withUnit(y, unit)],
        ],
      },
      marks: [
        Plot.ruleY([0], { stroke: theme.rule }),
        Plot.line(line, { x: "x", y: "y", stroke: theme.weak, strokeWidth: 1.1 }),
        Plot.line(line.slice(0, here(sample, state) + 2), { x: "x", y: "y", stroke: theme.strong, strokeWidth: 1.8 }),
        Plot.dot([rows[here(sample, state)]], {
          x: "x",
          y: "y",
          fill: theme.accent,
          r: 5.5,
          stroke: theme.card,
          strokeWidth: 1.5,
        }),
      ],
    });
    svg.style.cursor = "pointer";
    svg.addEventListener("click", () => svg.value && state.set({ step: svg.value.k, cracks: true, playing: false }));
    return svg;
  },
};

export const brokenBonds = {
  id: "broken-bonds",
  title: "Broken bonds",
  follows: ["step"],
  caption: "Number of broken bonds by type over the steps of the test; vertical line: the step shown.",
  when: (_, result) => hasCurve(_, result) && result.cracks,
  key: ({ sample, theme, state }) => {
    const counts = byType(sample, brokenAt(sample, here(sample, state)));
    return [1, 2, 3].map((type) => ({
      name: `${crackTypes[type]} ${text.count(counts[type])}`,
      colour: theme.crack[type],
      values: [],
    }));
  },
  draw({ sample, state, theme, width }) {
    const rows = [1, 2, 3].map((type) => ({ type, rows: [] })),
      counts = [0, 0, 0, 0];
    let k = 0;
    for (let step = 0; step < sample.steps; ++step) {
      for (const until = brokenAt(sample, step); k < until; ++k) ++counts[sample.cracks.type[k]];
      for (const line of rows) line.rows.push({ x: step + 1, y: counts[line.type] });
    }
    return chart(theme, {
      width,
      height: 254,
      x: { label: "step" },
      y: { label: "broken bonds", zero: true },
      tips: { points: rows.flatMap(({ type, rows: list }) => list.map((p) => ({ ...p, name: crackTypes[type] }))) },
      marks: [
        Plot.ruleX([here(sample, state) + 1], { stroke: theme.accent, strokeWidth: 1.25 }),
        ...rows.map(({ type, rows: list }) =>
          Plot.line(list, { x: "x", y: "y", stroke: theme.crack[type], strokeWidth: 1.7, curve: "step-after" }),
        ),
      ],
    });
  },
};

export const energyBalance = {
  id: "energy-balance",
  title: "Energy balance of the test",
  follows: ["step"],
  caption:
    "Per unit thickness. The work of the clamp is stored in bonds (elastic) or released when they break. Line: work; areas: its parts.",
  when: (_, result) => hasCurve(_, result) && result.curve.work && result.curve.elastic && result.curve.released,
  key: ({ theme }) => [
    { name: "work", colour: theme.strong, values: [] },
    { name: "elastic", colour: theme.materialLine[0], values: [] },
    { name: "released", colour: theme.materialLine[1], values: [] },
  ],
  draw({ sample, state, theme, width }) {
    const [{ values: work, unit }, { values: elastic }, { values: released }] = ["work", "elastic", "released"].map(
      (name) => column(sample, name, "work"),
    );
    const rows = work.map((w, k) => ({
      x: k + 1,
      work: w,
      elastic: elastic[k],
      released: released[k],
      all: released[k] + elastic[k],
    }));
    return chart(theme, {
      width,
      height: 254,
      x: { label: "step" },
      y: { label: "energy", unit, zero: true },
      tips: {
        points: rows.map((r) => ({ ...r, y: r.work })),
        lines: [
          ["step", ({ x }) => String(x)],
          ...["work", "elastic", "released"].map((name) => [name, (r) => withUnit(r[name], unit)]),
        ],
      },
      marks: [
        Plot.areaY(rows, { x: "x", y1: 0, y2: "released", fill: theme.materialLine[1], fillOpacity: 0.5 }),
        Plot.areaY(rows, { x: "x", y1: "released", y2: "all", fill: theme.materialLine[0], fillOpacity: 0.4 }),
        Plot.line(rows, { x: "x", y: "work", stroke: theme.strong, strokeWidth: 1.7 }),
        Plot.ruleX([here(sample, state) + 1], { stroke: theme.accent, strokeWidth: 1.25 }),
      ],
    });
  },
};
