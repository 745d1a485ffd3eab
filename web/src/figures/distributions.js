import * as Plot from "@observablehq/plot";
import { materialLine, pairColour } from "../theme.js";
import { chart, logAxis, points, sampled, sideBySide } from "./chart.js";

const ends = (sets) => Math.max(2.5, ...sets.map(({ d }) => d.maximum ?? 0)) * 1.03;

/** Survival function and its tail P_0 exp(beta (1 - x)), one line a set; a line at the value `selected`. */
export function cumulativeChart(theme, sets, { x, y, semilog, width, height = 262, selected = null }) {
  const top = ends(sets);
  const least = Math.min(...sets.map(({ d }) => 1 / d.count)) * 0.7;
  const shown = (list) => (semilog ? list.filter((p) => p.y >= least) : list);
  const data = sets.flatMap(({ d, colour, name }) => shown(points(d.cumulative, { colour, name })));
  const fits = sets
    .filter(({ d }) => d.beta && (d.P0 ?? d.strong_share))
    .map(({ d, colour, name }) => {
      const share = (d.P0 ?? d.strong_share).value;
      return { colour, name, line: shown(sampled(1, top, (v) => share * Math.exp(d.beta.value * (1 - v)))) };
    });
  return chart(theme, {
    width,
    height,
    x: { label: x, domain: [0, top] },
    y: semilog
      ? logAxis(y, [Math.min(least, 10 ** Math.floor(Math.log10(least) + 0.25)), 1])
      : { label: y, domain: [0, 1] },
    tips: { points: data },
    marks: [
      Plot.ruleX([1], { stroke: theme.soft, strokeDasharray: "2 3" }),
      selected === null
        ? null
        : Plot.ruleX([selected], { stroke: theme.accent, strokeWidth: 2, className: "selected" }),
      Plot.line(data, { x: "x", y: "y", z: "name", stroke: "colour", strokeWidth: 1.1, strokeOpacity: 0.35 }),
      Plot.dot(data, { x: "x", y: "y", fill: "colour", r: 1.8 }),
      ...fits.map(({ line, colour }) =>
        Plot.line(line, { x: "x", y: "y", stroke: colour, strokeWidth: 1.5, strokeDasharray: "6 3" }),
      ),
    ],
  });
}

function materialSets(sample, theme, distribution) {
  const { by_material = {}, ...all } = distribution,
    parts = sample.materials.length > 1 ? by_material : {}; // or there is one more of all
  return [
    { name: "all", d: all, colour: theme.strong },
    ...Object.entries(parts).map(([name, d]) => {
      const m = sample.materials.findIndex((material) => material.name === name);
      return { name, d, colour: m >= 0 ? materialLine(theme, m) : theme.mixedLine[1] };
    }),
  ].filter(({ d }) => d.count > 1);
}

function typeSets(sample, theme, distribution) {
  const { by_type = {}, ...all } = distribution,
    parts = sample.materials.length > 1 ? by_type : {};
  return [
    { name: "all", d: all, colour: theme.strong },
    ...Object.entries(parts).map(([name, d]) => {
      const type = sample.types.find((t) => t.key === name || t.key.split("-").reverse().join("-") === name);
      return { name: type?.label ?? name, d, colour: type ? pairColour(theme, type) : theme.mixedLine[1] };
    }),
  ].filter(({ d }) => d.count > 1);
}

const key = (sets, shareName) =>
  sets.map(({ name, colour, d }) => ({
    name,
    colour,
    values: [
      ["P_{0}", d[shareName]],
      ["\u03b2", d.beta],
    ].filter(([, v]) => v),
  }));

export const stressDistribution = {
  id: "sigma-norm",
  title: "Normalised stress of grains, \u03c3_{norm} = \u03c3_{hyd}/\u27e8\u03c3_{hyd}\u27e9",
  wide: true,
  caption:
    "P: survival function, the fraction of grains above \u03c3_{norm}. Dashed: P_{0} exp[\u03b2(1 \u2212 \u03c3_{norm})], maximum likelihood.",
  follows: ["selected"],
  when: (texture) => texture.sigma_norm?.cumulative,
  key: ({ sample, texture, theme }) => key(materialSets(sample, theme, texture.sigma_norm), "P0"),
  draw({ sample, state, texture, theme, width }) {
    const chosen = state.get("selected"),
      selected = chosen === null ? null : sample.snapshot(texture.snapshot).sigmaNorm[chosen];
    const sets = materialSets(sample, theme, texture.sigma_norm);
    const axes = { x: "\u03c3_{norm}", y: "P(\u03c3_{norm})" };
    return sideBySide(
      width,
      [false, true].map(
        (semilog) => (part) => cumulativeChart(theme, sets, { ...axes, semilog, width: part, selected }),
      ),
    );
  },
};

export const forceDistribution = {
  id: "forces",
  title: "Contact forces, F = F_{n}",
  wide: true,
  caption:
    "Left: density of F/\u27e8F\u27e9 (each type over its own mean), all contacts with counting errors, and the fits k x^{\u2212\u03b1} (weak) and k exp[\u03b2(1 \u2212 x)] (strong). Right: survival function, the fraction of contacts above.",
  when: (texture) => texture.force?.pdf,
  key: ({ sample, texture, theme }) => key(typeSets(sample, theme, texture.force), "strong_share"),
  draw({ sample, texture, theme, width }) {
    const sets = typeSets(sample, theme, texture.force);
    return sideBySide(width, [
      (part) => densityChart(theme, sets, part),
      (part) =>
        cumulativeChart(theme, sets, { x: "F/\u27e8F\u27e9", y: "survival function", semilog: true, width: part }),
    ]);
  },
};

function densityChart(theme, sets, width) {
  const [all] = sets;
  const top = ends(sets);
  const least = Math.min(...sets.flatMap(({ d }) => d.pdf.y.filter((v) => v > 0)));
  const domain = [
    10 ** Math.floor(Math.log10(least)),
    Math.max(2, 1.3 * Math.max(...sets.flatMap(({ d }) => d.pdf.y))),
  ];
  const data = sets.flatMap(({ d, colour, name }) => points(d.pdf, { colour, name })).filter((p) => p.y > 0);
  const whiskers = data
    .filter((p) => p.name === "all" && p.error > 0)
    .map((p) => ({ ...p, low: Math.max(domain[0], p.y - p.error), high: p.y + p.error }));
  const { k, alpha, beta } = all.d;
  const weak = k && alpha ? sampled(0.02, 1, (x) => k.value * x ** -alpha.value) : [];
  const strong = k && beta ? sampled(1, top, (x) => k.value * Math.exp(beta.value * (1 - x))) : [];
  const inside = (list) => list.filter((p) => p.y >= domain[0] && p.y <= domain[1]);
  return chart(theme, {
    width,
    height: 262,
    x: { label: "F/\u27e8F\u27e9", domain: [0, top] },
    y: { ...logAxis("probability density", domain), short: "density" },
    tips: { points: data, by: "both" },
    marks: [
      Plot.ruleX([1], { stroke: theme.soft, strokeDasharray: "2 3" }),
      Plot.dot(
        data.filter((p) => p.name !== "all"),
        { x: "x", y: "y", fill: "colour", r: 2, fillOpacity: 0.75 },
      ),
      Plot.ruleX(whiskers, { x: "x", y1: "low", y2: "high", stroke: theme.strong, strokeOpacity: 0.5 }),
      Plot.dot(
        data.filter((p) => p.name === "all"),
        { x: "x", y: "y", fill: theme.strong, r: 2.6 },
      ),
      Plot.line(inside(weak), { x: "x", y: "y", stroke: theme.fit, strokeWidth: 1.5, strokeDasharray: "6 3" }),
      Plot.line(inside(strong), { x: "x", y: "y", stroke: theme.fit, strokeWidth: 1.5, strokeDasharray: "6 3" }),
    ],
  });
}
