import * as Plot from "@observablehq/plot";
import { components } from "../field/components.js";
import { chart, decades, logAxis, sideBySide } from "./chart.js";

const clampRows = 4;  // at the lower and the upper edge, where the sample is held

export const phaseSets = [
  { kind: null, name: "all" }, { kind: 4, name: "large" }, { kind: 3, name: "small" }, { kind: 2, name: "grains" }, { kind: 1, name: "matrix" },
];

export function setColour(theme, kind) {
  return kind === null ? theme.strong : theme.kindLine[kind];
}

/** Densities of a component over nodes of each phase: [{ kind, name, mean, count, points: [{ x, y, error }] }], x in units
    of the sample's mean, or of the set's own. */
export function densities(result, component, own) {
  const { map } = result, values = result.values(component);
  const rows = Math.max(1, Math.ceil(clampRows / map.stride)), from = rows * map.width, to = map.size - from;
  return phaseSets.map((set) => {
    const kept = [];
    for (let k = from; k < to; ++k) if (set.kind === null ? map.kind[k] !== 0 : map.kind[k] === set.kind) kept.push(values[k]);
    return { ...set, kept };
  }).filter(({ kept }) => kept.length > 50).map(({ kept, ...set }) => {
    const mean = kept.reduce((sum, v) => sum + v, 0) / kept.length;
    const unit = own ? mean : result.scale;
    return { ...set, mean, count: kept.length, ...histogram(kept, unit) };
  });
}

/** Bins as wide as 2 IQR/n^(1/3) says, not below a hundredth of the unit; the tails beyond one count in 1e5 left out. */
function histogram(values, unit) {
  const x = Float64Array.from(values, (v) => v / unit).sort(), n = x.length, at = (share) => x[Math.round(share * (n - 1))];
  const width = Math.max(0.01, (2 * (at(0.75) - at(0.25))) / Math.cbrt(n));
  const low = Math.floor(at(2e-5) / width) * width, bins = Math.min(4000, Math.ceil((at(1 - 2e-5) - low) / width) + 1);
  const counts = new Array(bins).fill(0);
  for (const v of x) {
    const k = Math.floor((v - low) / width);
    if (k >= 0 && k < bins) ++counts[k];
  }
  const points = counts.map((c, k) => ({ x: low + (k + 0.5) * width, y: c / (n * width), n: c })).filter(({ n: c }) => c > 0);
  return { points, from: at(0.002), to: at(0.998), deviation: deviation(x) };
}

function deviation(x) {
  const mean = x.reduce((s, v) => s + v, 0) / x.length;
  return Math.sqrt(x.reduce((s, v) => s + (v - mean) ** 2, 0) / x.length);
}

const cached = (result, component, own) => {
  const key = `${component} ${own}`;
  result.densities ??= new Map();
  if (!result.densities.has(key)) result.densities.set(key, densities(result, component, own));
  return result.densities.get(key);
};

function of(sample, state) {
  const name = state.get("component"), shown = components[name].unit === "Pa" ? name : "yy";
  const own = state.get("norm") === "own" && shown === "yy";
  return { name: shown, own, sets: cached(sample, shown, own) };
}

export const stressDensities = {
  id: "stress-pdf", title: "Stress of nodes by phase", wide: true, follows: ["component", "norm"],
  caption: "Probability density of the component that the picture shows, over the mean \u27e8\u03c3_{yy}\u27e9 of the sample (or, on demand, \u03c3_{yy} over the mean of each phase); the four clamped rows at both ends left out.",
  choices: { norm: ["Over the mean of", [["sample", "the sample"], ["own", "the phase"]]] },
  when: (_, result) => result.loaded,
  key: ({ sample, state, theme }) => of(sample, state).sets.map(({ kind, name, mean, deviation: spread }) =>
    ({ name, colour: setColour(theme, kind), values: [["mean", { value: mean / sample.scale }], ["s.d.", { value: spread }]] })),
  draw({ sample, state, theme, width }) {
    const { name, own, sets } = of(sample, state);
    const label = `${components[name].symbol} / \u27e8\u03c3_{yy}\u27e9${own ? " of the phase" : ""}`;
    return sideBySide(width, [false, true].map((semilog) => (part) => densityChart(theme, sets, { label, semilog, width: part })));
  },
};

function densityChart(theme, sets, { label, semilog, width }) {
  const most = Math.max(...sets.flatMap(({ points }) => points.map((p) => p.y)));
  const domain = [10 ** Math.floor(Math.log10(most * 2e-5)), 10 ** Math.ceil(Math.log10(most))];
  const ends = semilog ? [Math.min(...sets.map(({ points }) => points[0].x)), Math.max(...sets.map(({ points }) => points.at(-1).x))]
    : [Math.min(...sets.map(({ from }) => from)), Math.max(...sets.map(({ to }) => to))];
  const lines = sets.map(({ kind, points }) => ({ colour: setColour(theme, kind), wide: kind === null ? 2.2 : 1.5, rows: points.filter((p) => p.x >= ends[0] && p.x <= ends[1] && (!semilog || p.y >= domain[0])) }));
  return chart(theme, {
    width, height: 270,
    x: { label, domain: ends, ticks: Math.max(3, Math.round(width / 90)) },
    y: semilog ? { ...logAxis("probability density", domain), tickFormat: logAxis("", domain).tickFormat, ticks: decades(domain) } : { label: "probability density", domain: [0, 1.04 * most] },
    marks: [
      Plot.ruleX([1], { stroke: theme.soft, strokeDasharray: "2 3" }),
      ...lines.map(({ rows, colour, wide }) => Plot.line(rows, { x: "x", y: "y", stroke: colour, strokeWidth: wide, curve: semilog ? "linear" : "basis" })),
    ],
  });
}
