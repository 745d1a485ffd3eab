import * as Plot from "@observablehq/plot";
import { h } from "../dom.js";
import { chart, decades } from "../figures/chart.js";
import { captionOf } from "./caption.js";
import { fieldFigure } from "./field.js";
import { mapFigure } from "./map.js";
import { roseFigure } from "./rose.js";
import { sampleFigure } from "./sample.js";

/** Those that differ most come first. */
const hues = (theme) => [...theme.materialLine, ...[1, 2, 3, 0].map((k) => theme.mixedLine[k])];

/** Colours of curves in their order: a scale where they are values of one key, distinct hues otherwise. */
function colours(theme, figure) {
  const ours = figure.series.filter(({ beside, source }) => !beside && !source);
  const groups = [...new Set(ours.map(({ group }) => group))],
    n = groups.length;
  if (figure.ordered && n > 2)
    return figure.series.map(({ group, beside }) => (beside ? theme.ink : theme.size(groups.indexOf(group) / (n - 1))));
  const list = hues(theme),
    simulated = ours.filter(({ film, fit }) => !film && !fit).length;
  // In a plot a film's points have the colour of what was simulated, and are hollow.
  const place = ({ part, film, source }) =>
    film && !source && figure.kind === "plot" ? part % Math.max(1, simulated) : part;
  return figure.series.map((one) =>
    one.beside ? theme.ink : list[(figure.ordered ? groups.indexOf(one.group) : place(one)) % list.length],
  );
}

/** Several curves of one value of a key have its colour; all but the first are dashed. */
const dash = (figure, { part, film, source, beside }) =>
  source || beside ? null : film && figure.kind === "plot" ? "1.5 3" : figure.ordered && part > 0 ? "4 3" : null;

const short = (v) => (Math.abs(v) >= 1e4 ? v.toExponential().replace("e+", "e") : `${Number(v.toPrecision(6))}`);

function axis({ label, log, domain }) {
  if (!log) return { label, domain, ticks: 5, tickFormat: short };
  return {
    label,
    type: "log",
    domain,
    ticks: decades(domain).length > 1 ? decades(domain) : 4,
    tickFormat: (v) => `${Number(v.toPrecision(3))}`,
  };
}

/** Whether the labels of the ticks need more room than five digits do. */
function hasWideTicks({ log, domain: [low, high] }) {
  if (log) return low < 1e-3 || high >= 1e4;
  const digits = Math.max(0, Math.ceil(-Math.log10((high - low) / 5)));
  return Math.max(Math.abs(low), Math.abs(high)) >= 1e4 || digits > 3;
}

const known = (p) => p && !Number.isNaN(p.y);

/** The source's points are crosses: upright ones are what it measured where it also simulated. */
const symbolOf = ({ source, film, beside }) => (source ? (film ? "plus" : "times") : beside ? "diamond" : "circle");

/** Bands of the scatter of densities that are drawn as lines. */
function band({ points, fit, source }, colour, { lines, density, y }) {
  if (!density || !lines || fit || source || !points.some(({ e }) => e > 0)) return [];
  return [
    Plot.areaY(points, {
      x: "x",
      y1: (p) => Math.max(p.low, y.log ? y.domain[0] : -Infinity),
      y2: (p) => p.y + p.e,
      fill: colour,
      fillOpacity: 0.2,
      clip: true,
    }),
  ];
}

/** Points with their error bars, joined where the figure says so; densities are lines alone, what is fitted to them is dashed. */
function curve(one, theme, colour, { lines, density, y }, dashed) {
  const { points: all, film, fit, source, beside } = one;
  if (fit)
    return [
      Plot.line(all, {
        x: "x",
        y: "y",
        stroke: theme.ink,
        strokeWidth: 1.4,
        strokeDasharray: film ? "1.5 3" : "5 3",
        clip: true,
      }),
    ];
  if (source)
    return [Plot.dot(all, { x: "x", y: "y", symbol: symbolOf(one), r: 3.6, stroke: colour, strokeWidth: 1.4 })];
  const points = all.filter((p) => p.y >= y.domain[0]),
    alone = all.filter((p, k) => p.y >= y.domain[0] && !known(all[k - 1]) && !known(all[k + 1]));
  const line = Plot.line(density ? all : points, {
    x: "x",
    y: "y",
    stroke: colour,
    strokeWidth: 1.6,
    strokeDasharray: dashed,
    strokeOpacity: density ? 1 : 0.75,
  });
  const bars = (of) =>
    Plot.ruleX(
      of.filter((p) => p.e > 0),
      { x: "x", y1: (p) => p.low, y2: (p) => p.y + p.e, stroke: colour, strokeWidth: density ? 0.8 : 1.2 },
    );
  if (density && lines) return [line, bars(alone), Plot.dot(alone, { x: "x", y: "y", r: 1.6, fill: colour })];
  return [
    lines && !(beside && points.every((p) => p.x === points[0].x)) && line,
    bars(points),
    Plot.dot(
      points,
      film
        ? { x: "x", y: "y", r: 2.6, fill: theme.card, stroke: colour, strokeWidth: 1.2 }
        : { x: "x", y: "y", r: beside ? 3.4 : 2.6, fill: colour, symbol: symbolOf(one) },
    ),
  ].filter(Boolean);
}

/** What the source's text says: a line across, a line upright or a point; or a line through the origin. */
function reference(theme, { x, y, slope }, domains) {
  const stroke = { stroke: theme.accent, strokeDasharray: "4 3", strokeWidth: 1.1 };
  if (slope !== undefined)
    return [
      Plot.line(
        domains.x.map((at) => [at, slope * at]),
        { ...stroke, clip: true },
      ),
    ];
  if (x !== undefined && y !== undefined)
    return [Plot.dot([0], { x: () => x, y: () => y, symbol: "times", r: 4, stroke: theme.accent })];
  return [y !== undefined ? Plot.ruleY([y], stroke) : Plot.ruleX([x], stroke)];
}

/** Its words, over the curves. */
function noteOf(theme, { x, y, slope, label }, domains, row) {
  if (slope !== undefined) return [];
  const note = { text: () => label, fill: theme.accent, stroke: theme.card, strokeWidth: 3, fontSize: 10.5 };
  if (x !== undefined && y !== undefined) return [Plot.text([0], { x: () => x, y: () => y, dy: -9, ...note })];
  if (y !== undefined)
    return [Plot.text([0], { x: () => domains.x[1], y: () => y, textAnchor: "end", dy: -6, ...note })];
  const right = x > 0.6 * domains.x[1] + 0.4 * domains.x[0];
  return [
    Plot.text([0], {
      x: () => x,
      y: () => domains.y[1],
      textAnchor: right ? "end" : "start",
      dx: right ? -4 : 4,
      dy: 5 + 13 * row,
      ...note,
    }),
  ];
}

/** An entry for every curve, where there are several or it has a name. */
function keyOf(figure, theme) {
  const list = figure.series.map((one, k) => ({ ...one, colour: colours(theme, figure)[k] })).filter(({ fit }) => !fit);
  if (list.length < 2 && !list[0]?.name) return [];
  return list.map((one) => ({
    name: one.name,
    colour: one.colour,
    dash: dash(figure, one),
    symbol: one.source || one.beside ? symbolOf(one) : null,
  }));
}

/** One of which nothing is there: the sentence that says why. */
function absentFigure(figure) {
  return {
    id: figure.id,
    title: figure.title,
    caption: captionOf({ ...figure, missing: "" }),
    draw: () => h("p", { class: "nothing" }, figure.missing),
  };
}

export function studyFigure(figure) {
  if (figure.missing && !figure.sample && figure.series.length === 0) return absentFigure(figure);
  if (figure.kind === "rose") return roseFigure(figure, colours, dash);
  if (figure.kind === "map") return mapFigure(figure);
  if (figure.sample?.nodes) return fieldFigure(figure);
  if (figure.sample) return sampleFigure(figure);
  const low = figure.y.log ? (p) => Math.max(p.y - p.e, figure.y.domain[0]) : (p) => p.y - p.e;
  const series = figure.series.map(({ points, ...one }) => ({
    ...one,
    points: points.map(([x, y, e]) => ({ x, y: y ?? NaN, e })).map((p) => ({ ...p, low: low(p) })),
  }));
  const wide = hasWideTicks(figure.y);
  const domains = { x: figure.x.domain, y: figure.y.domain };
  return {
    id: figure.id,
    title: figure.title,
    caption: captionOf(figure),
    key: ({ theme }) => keyOf(figure, theme),
    draw: ({ theme, width }) =>
      series.length > 0 &&
      chart(theme, {
        width,
        height: 260,
        marginLeft: wide ? 78 : 62,
        x: axis(figure.x),
        y: { ...axis(figure.y), labelOffset: wide ? 71 : 56 },
        tips: {
          by: "both",
          points: series
            .filter(({ fit }) => !fit)
            .flatMap(({ name, points }) =>
              points
                .filter((p) => known(p) && p.y >= domains.y[0] && p.y <= domains.y[1])
                .map(({ x, y, e }) => ({ x, y, error: e, name })),
            ),
        },
        marks: [
          ...(figure.references ?? []).flatMap((r) => reference(theme, r, domains)),
          ...series.flatMap((one, k) => band(one, colours(theme, figure)[k], figure)),
          ...series.flatMap((one, k) =>
            curve(one, theme, colours(theme, figure)[k], figure, dash(figure, figure.series[k])),
          ),
          ...(figure.references ?? []).flatMap((r, row) => noteOf(theme, r, domains, row)),
        ],
      }),
  };
}
