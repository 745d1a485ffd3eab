import * as Plot from "@observablehq/plot";
import { contactName } from "../film/tooltip.js";
import { text } from "../text.js";
import { dashOf } from "./colours.js";

/** What one point of a series is called. */
function nameOf({ name, each, members }, k, sample) {
  if (each === "step") return `step ${text.count(k + 1)}`;
  if (each === "contact") return contactName(sample, members[k]);
  if (each === "grain") return `Grain ${members[k]}${sample.materials.length > 1 ? `, ${name}` : ""}`;
  return name;
}

/** Its points, each with its name and what else is known of it. */
export const pointsOf = (series, sample) =>
  Array.from(series.x, (x, k) => ({
    k,
    x,
    y: series.y[k],
    at: series.bars && series.high ? series.high[k] : series.y[k],
    error: series.error?.[k] || 0,
    low: series.low?.[k],
    high: series.high?.[k],
    name: nameOf(series, k, sample),
  }));

/** Whether a number lies on an axis, up to the rounding of its ends. */
export function inside({ low, high }, value) {
  const slack = 1e-6 * Math.max(Math.abs(low ?? 0), Math.abs(high ?? 0));
  return Number.isFinite(value) && !(value < low - slack) && !(value > high + slack);
}

/** The marks of one series whose colour is known. */
export function marksOf(series, points, colour, { x: xAxis, y: yAxis }, theme) {
  const { line, steps, weight = 1, opacity = 1, bars } = series,
    there = points.filter((p) => inside(xAxis, p.x) && inside(yAxis, p.at));
  if (bars)
    return [
      Plot.rect(there, {
        x1: (p) => p.x - bars / 2,
        x2: (p) => p.x + bars / 2,
        y1: (p) => p.low ?? 0,
        y2: "at",
        fill: colour,
        fillOpacity: opacity,
        rx: 1,
      }),
    ];
  const band =
    series.low &&
    Plot.areaY(points, { x: "x", y1: "low", y2: "high", fill: colour, fillOpacity: line ? 0.2 : opacity, clip: true });
  if (band && !line) return [band];
  const drawn = yAxis.log ? points.map((p) => (p.y > 0 ? p : { ...p, y: NaN })) : points,
    spread = band ? [] : there.filter((p) => p.error > 0);
  return [
    band,
    spread.length > 0 &&
      Plot.ruleX(spread, {
        x: "x",
        y1: (p) => Math.max(yAxis.log ? yAxis.low : -Infinity, p.y - p.error),
        y2: (p) => p.y + p.error,
        stroke: colour,
        strokeOpacity: 0.5 * opacity + 0.05,
        clip: true,
      }),
    line &&
      Plot.line(drawn, {
        x: "x",
        y: "y",
        stroke: colour,
        strokeWidth: 1.6 * weight,
        strokeOpacity: series.points ? 0.75 : opacity,
        strokeDasharray: dashOf(line),
        curve: steps ? "step-after" : "linear",
        clip: true,
      }),
    series.points && dots(there, series, colour, theme),
  ].filter(Boolean);
}

/** Points as dots, hollow ones, diamonds or crosses. */
function dots(points, { mark, weight = 1, opacity = 1 }, colour, theme) {
  const at = { x: "x", y: "y", r: 2.6 * weight };
  if (mark === "times" || mark === "plus")
    return Plot.dot(points, { ...at, r: 3.6 * weight, symbol: mark, stroke: colour, strokeWidth: 1.4 });
  if (mark === "hollow") return Plot.dot(points, { ...at, fill: theme.card, stroke: colour, strokeWidth: 1.2 });
  const diamond = mark && { symbol: mark, r: 3.4 * weight };
  return Plot.dot(points, { ...at, fill: colour, fillOpacity: opacity, ...diamond });
}
