import * as Plot from "@observablehq/plot";
import { text } from "../text.js";
import { chart, decadesAround, logAxis } from "./chart.js";

const kinds = [
  ["pores", "pores", 0],
  ["voids", "voids", 1],
];

const volumesOf = ({ declared }, kind) => declared.at(kind) ?? {};

function sets(result, theme) {
  return kinds
    .map(([kind, name, k]) => ({ ...volumesOf(result, kind), name, colour: theme.materialLine[k] }))
    .filter(({ pdf }) => pdf)
    .map(({ name, count, ...set }) => ({ ...set, name: `${name} ${text.count(count)}` }));
}

export const cavityVolumes = {
  id: "cavities",
  title: "Single pores and voids",
  caption:
    "Probability density of the volumes of single pores (not grain) and single voids (neither grain nor matrix), over that of a large grain of nominal radius (reference radius in the table), with counting errors. The table states which volumes at the edge and which specks of the grid are left out.",
  when: (_, result) =>
    kinds.some(([kind]) => (volumesOf(result, kind).pdf?.density.filter((d) => d > 0).length ?? 0) > 2),
  key: ({ sample, theme }) =>
    sets(sample, theme).map(({ name, colour, mean, cv }) => ({
      name,
      colour,
      values: [
        ["mean", { value: mean.value }],
        ["c.v.", { value: cv.value }],
      ],
    })),
  draw({ sample, theme, width }) {
    const lines = sets(sample, theme).map((set) => ({ ...set, rows: rowsOf(set) }));
    const all = lines.flatMap(({ rows }) => rows),
      y = all.map((r) => r.y);
    const domain = decadesAround(Math.min(...y), Math.max(...y));
    const xAxis = logAxis("V / (\u03c0 r_{L}\u00b2)", [
      Math.min(...all.map((r) => r.low)),
      Math.max(...all.map((r) => r.high)),
    ]);
    return chart(theme, {
      width,
      height: 254,
      x: xAxis,
      y: { ...logAxis("probability density", domain), short: "density" },
      tips: { points: lines.flatMap(({ name, rows }) => rows.map((r) => ({ ...r, name }))) },
      marks: lines.flatMap(({ rows, colour }) => [
        Plot.ruleX(rows, {
          x: "x",
          y1: (r) => Math.max(domain[0], r.y - r.error),
          y2: (r) => r.y + r.error,
          stroke: colour,
          strokeOpacity: 0.5,
        }),
        Plot.line(rows, { x: "x", y: "y", stroke: colour, strokeWidth: 1.5 }),
        Plot.dot(rows, { x: "x", y: "y", fill: colour, r: 2.2 }),
      ]),
    });
  },
};

/** Bins that hold any, at their geometric middle. */
function rowsOf({ pdf: { edge, density, error } }) {
  return density
    .map((y, k) => ({ x: Math.sqrt(edge[k] * edge[k + 1]), y, error: error[k], low: edge[k], high: edge[k + 1] }))
    .filter(({ x, y }) => y > 0 && x > 0);
}
