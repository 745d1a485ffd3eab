import * as Plot from "@observablehq/plot";
import { inWords } from "../declared.js";
import { prefixOf, text } from "../text.js";
import { chart, sideBySide } from "./chart.js";

const ratioLabels = {
  mu: "friction, shear over normal force",
  q_over_p: "q/p from the forces on the sides",
  axial_stress: "stress along the axis",
};
const symbols = { mu: "\u03bc", q_over_p: "q/p" };

/** The stage of the state that is shown. */
const stageOf = (sample, state) => sample.stages[sample.about.snapshots[state.get("snapshot")].stage];

/** The curves of a stage as the program measured them: { strain, ratio: [{ x, y }], volume, critical }. Strains of sides in per cent. */
function curvesOf(stage) {
  const test = stage?.test;
  if (!test) return null;
  const factor = test.strain_name === "shear strain" ? 1 : 100;
  const against = (values, scale) =>
    Array.from(test.strain, (x, k) => ({ x: factor * x, y: scale * values[k] })).filter(
      ({ y }) => Number.isFinite(y) && Math.abs(y) < 200,
    );
  const critical = test.critical_state;
  if (test.ratio_name === "axial_stress") return uniaxial(test, factor);
  return {
    strain: { label: test.strain_name, unit: factor === 1 ? "" : "%" },
    symbol: symbols[test.ratio_name],
    ratioLabel: ratioLabels[test.ratio_name],
    ratio: against(test.ratio, 1).filter(({ y }) => y < 2),
    volume: against(test.volume, 100),
    critical: critical && {
      from: factor * critical.from,
      to: factor * critical.to,
      ratio: half(critical[test.ratio_name]),
      solid: half(critical.solid_fraction),
    },
  };
}

/** The stage whose curves are shown: that of the state shown, or else the last before it that has any, or the first after it. */
export function stageWithCurves(sample, state) {
  const shown = sample.stages.indexOf(stageOf(sample, state));
  const candidates = [...sample.stages.slice(0, shown + 1).reverse(), ...sample.stages.slice(shown + 1)];
  return candidates.find((stage) => curvesOf(stage)) ?? null;
}

/** The stress of a test without confinement or in tension: its ratio says nothing, and its volume is not that of the box. */
function uniaxial(test, factor) {
  const { factor: size, unit } = prefixOf(Math.max(...Array.from(test.ratio, Math.abs)), test.ratio.unit);
  return {
    strain: { label: test.strain_name, unit: "%" },
    ratioLabel: ratioLabels.axial_stress,
    ratioUnit: unit,
    ratio: Array.from(test.strain, (x, k) => ({ x: factor * x, y: test.ratio[k] / size })).filter(({ y }) =>
      Number.isFinite(y),
    ),
  };
}

/** A number of the critical state with half its 95 % interval as error. */
const half = ({ value, low_95: low, high_95: high }) => ({ value, low, high, error: (high - low) / 2 });

/** What a stage's critical state says, for the headlines; none without one. */
export function criticalTiles(stage) {
  const curves = curvesOf(stage);
  if (!curves?.critical) return [];
  return [
    [curves.symbol, curves.critical.ratio],
    ["\u03c6", curves.critical.solid],
  ].map(([symbol, number]) => ({ words: "critical state, 95\u202f%", symbol, ...inWords(number, "") }));
}

/** The curve thinned to means over about as many stretches as can be told apart. */
function smooth(points, most = 160) {
  const step = Math.ceil(points.length / most);
  if (step < 3) return points;
  const result = [];
  for (let k = 0; k < points.length; k += step) {
    const part = points.slice(k, k + step),
      mean = (key) => part.reduce((sum, p) => sum + p[key], 0) / part.length;
    result.push({ x: mean("x"), y: mean("y") });
  }
  return result;
}

/** The plateau's band of 95 % and its mean, over the strain that it was taken from. */
function plateau(theme, critical) {
  if (!critical) return [];
  const ends = [critical.from, critical.to].map((x) => ({
    x,
    y: critical.ratio.value,
    low: critical.ratio.low,
    high: critical.ratio.high,
  }));
  return [
    Plot.areaY(ends, { x: "x", y1: "low", y2: "high", fill: theme.accent, fillOpacity: 0.25 }),
    Plot.line(ends, { x: "x", y: "y", stroke: theme.accent, strokeWidth: 1.7 }),
  ];
}

function panel(theme, strain, points, y, width, critical = null) {
  const curve = smooth(points);
  return chart(theme, {
    width,
    height: 236,
    marginLeft: 60,
    x: { label: strain.label, unit: strain.unit, ticks: 5 },
    y,
    tips: { points: curve },
    marks: [
      ...(curve === points
        ? []
        : [Plot.line(points, { x: "x", y: "y", stroke: theme.weak, strokeOpacity: 0.35, strokeWidth: 0.7 })]),
      Plot.line(curve, { x: "x", y: "y", stroke: theme.strong, strokeWidth: 1.7 }),
      ...plateau(theme, critical),
    ],
  });
}

export const testCurves = {
  follows: true,
  when: (texture, sample) => sample.stages.some((stage) => curvesOf(stage)),
  key: ({ sample, state, theme }) => {
    const { critical, symbol } = curvesOf(stageWithCurves(sample, state)) ?? {};
    return critical
      ? [
          {
            name: "critical state",
            colour: theme.accent,
            numbers: [
              [symbol, critical.ratio],
              ["\u03c6", critical.solid],
            ].map(([of, number]) => [of, ...Object.values(text.withError(number.value, number.error))]),
          },
        ]
      : [];
  },
  draw({ sample, state, theme, width }) {
    const stage = stageWithCurves(sample, state),
      curves = curvesOf(stage);
    if (!curves) return null;
    if (stage !== stageOf(sample, state)) curves.strain.label += ` in \u201c${stage.name}\u201d`;
    if (!curves.volume)
      return panel(
        theme,
        curves.strain,
        curves.ratio,
        { label: curves.ratioLabel, unit: curves.ratioUnit, nice: true },
        width,
      );
    return sideBySide(width, [
      (part) =>
        panel(theme, curves.strain, curves.ratio, { label: curves.ratioLabel, nice: true }, part, curves.critical),
      (part) => panel(theme, curves.strain, curves.volume, { label: "volumetric strain", unit: "%", nice: true }, part),
    ]);
  },
};
