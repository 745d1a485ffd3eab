import * as Plot from "@observablehq/plot";
import { richSvg, s } from "../dom.js";
import { contactName } from "../film/tooltip.js";
import { text } from "../text.js";
import { chart, logAxis } from "./chart.js";
import { colourOf, dashOf } from "./colours.js";
import { withUnit } from "./tips.js";

/** What one point of a series is called. */
function nameOf({ name, each, members }, k, sample) {
  if (each === "step") return `step ${text.count(k + 1)}`;
  if (each === "contact") return contactName(sample, members[k]);
  if (each === "grain") return `Grain ${members[k]}${sample.materials.length > 1 ? `, ${name}` : ""}`;
  return name;
}

const pointsOf = (series, sample) =>
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
function inside({ low, high }, value) {
  const slack = 1e-6 * Math.max(Math.abs(low ?? 0), Math.abs(high ?? 0));
  return Number.isFinite(value) && !(value < low - slack) && !(value > high + slack);
}

const isWhole = (panel) =>
  !panel.x.unit && panel.series.every(({ x }) => x.every(Number.isInteger)) && panel.series.some(({ x }) => x.length > 1);

function axisOf({ label, unit, brief, log, low, high }, whole = false) {
  const domain = low === undefined || high === undefined ? undefined : [low, high];
  if (log) return { ...logAxis(label, domain), unit, short: brief };
  return {
    label,
    unit,
    short: brief,
    ticks: 5,
    ...(domain ? { domain } : { nice: true, zero: low === 0 }),
    ...(whole && { tickFormat: (v) => (Number.isInteger(v) ? String(v) : "") }),
  };
}

/** The marks of one series whose colour is known. */
function marksOf(series, points, colour, { x: xAxis, y: yAxis }) {
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
  if (series.low)
    return [Plot.areaY(points, { x: "x", y1: "low", y2: "high", fill: colour, fillOpacity: opacity, clip: true })];
  const drawn = yAxis.log ? points.map((p) => (p.y > 0 ? p : { ...p, y: NaN })) : points,
    spread = there.filter((p) => p.error > 0);
  return [
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
    series.points && Plot.dot(there, { x: "x", y: "y", fill: colour, fillOpacity: opacity, r: 2.5 * weight }),
  ].filter(Boolean);
}

/** Bars that lie, each with its number behind it. */
function lyingPanel(panel, { theme, width, sample }) {
  const names = panel.y.names;
  const rows = panel.series.flatMap((series) =>
    pointsOf(series, sample).map((p) => ({ ...p, label: names[p.x], colour: colourOf(theme, series.colour) })),
  );
  const widest = Math.max(...names.map((name) => name.length)),
    marginLeft = Math.max(60, 24 + 6.2 * widest),
    room = width - marginLeft - 14,
    top = (Math.max(...rows.map((r) => r.y + r.error)) * room) / Math.max(0.3 * room, room - 96);
  const words = (r) => {
    const { value, error } = text.withError(r.y, r.error);
    return value + (error && ` \u00b1 ${error}`);
  };
  return chart(theme, {
    width,
    height: 34 * rows.length + 52,
    marginLeft,
    gridTicks: [],
    x: { ...axisOf(panel.x), domain: [0, top], nice: false, zero: false },
    y: { label: null, domain: names, padding: 0.34, ticks: undefined },
    tips: {
      points: rows.map((r) => ({ ...r, x: r.y, y: r.label })),
      by: "y",
      reach: 200,
      lines: [
        ["", ({ y }) => y],
        [panel.x.brief ?? panel.x.label, ({ x, error }) => withUnit(x, panel.x.unit ?? "", error)],
      ],
    },
    marks: [
      Plot.gridX({ stroke: theme.rule, strokeOpacity: 1, ticks: 5 }),
      Plot.barX(rows, { x: "y", y: "label", fill: "colour", fillOpacity: 0.82, rx: 1.5 }),
      Plot.ruleY(rows, {
        x1: (r) => r.y - r.error,
        x2: (r) => r.y + r.error,
        y: "label",
        stroke: theme.ink,
        strokeWidth: 1.5,
      }),
      Plot.text(rows, {
        x: (r) => r.y + r.error,
        y: "label",
        dx: 7,
        textAnchor: "start",
        fill: theme.ink,
        text: words,
      }),
    ],
  });
}

/** Where the reader's choice is: a line, or a dot on a curve. */
function nowMarks({ now }, here, theme) {
  if (!now || !(here < now.x.length)) return [];
  if (!now.y) return [Plot.ruleX([now.x[here]], { stroke: theme.accent, strokeWidth: 1.25 })];
  return [
    Plot.dot([0], {
      x: () => now.x[here],
      y: () => now.y[here],
      fill: theme.accent,
      r: 5.5,
      stroke: theme.card,
      strokeWidth: 1.5,
    }),
  ];
}

/** The place of the grain that is selected, upright. */
function selectedMarks({ selected, x }, { sample, state, texture, theme }) {
  const g = selected ? state.get("selected") : null;
  if (g === null || g === undefined) return [];
  const at = selected === "diameter" ? 2e3 * sample.radius[g] : sample.snapshot(texture.snapshot).sigmaNorm[g];
  return inside(x, at) ? [Plot.ruleX([at], { stroke: theme.accent, strokeWidth: 2, className: "selected" })] : [];
}

function referenceMark({ x, y, colour, line }, theme) {
  const options = { stroke: colourOf(theme, colour), strokeDasharray: dashOf(line) };
  return x === undefined ? Plot.ruleY([y], options) : Plot.ruleX([x], options);
}

/** Lines of text in the upper left corner, on a patch of the card's colour. */
function withCorner(svg, theme, lines, left) {
  const wide = 12 + 6 * Math.max(...lines.map((line) => line.replace(/[_{}]/g, "").length));
  svg.append(
    s("rect", {
      x: left,
      y: 13,
      width: wide,
      height: 16 * lines.length + 6,
      rx: 4,
      fill: theme.card,
      "fill-opacity": 0.85,
    }),
    s(
      "g",
      { "text-anchor": "start", "font-family": theme.font, fill: theme.ink },
      lines.map((line, k) => s("text", { x: left + 6, y: 28 + 16 * k }, line)),
    ),
  );
  return richSvg(svg);
}

/** One panel as an SVG; `about` is what a card gives, with `here`, the place of what the reader chose. */
export function drawPanel(panel, { width, height = 254, ...about }) {
  const { theme, sample, state, here } = about;
  if (panel.lying) return lyingPanel(panel, { ...about, width });
  const drawn = panel.series.map((series) => ({
    series,
    colour: colourOf(theme, series.colour),
    points: pointsOf(series, sample),
  }));
  const read = drawn.filter(({ series }) => !series.silent);
  const told = read.flatMap(({ points }) => points),
    named = told.some(({ name }) => name);
  const near = told
    .filter((p) => inside(panel.x, p.x) && inside(panel.y, p.at))
    .map((p) => ({ ...p, value: p.y, y: p.at }));
  const bottom = panel.series.some(({ bars }) => bars) && panel.x.low === undefined ? { nice: true } : {};
  const svg = chart(theme, {
    width,
    height: panel.square ? Math.round(Math.min(380, Math.max(240, width - 10))) : height,
    x: { ...axisOf(panel.x, isWhole(panel)), ...bottom },
    y: axisOf(panel.y),
    tips: {
      points: near,
      by: panel.near ? "both" : "x",
      reach: panel.click ? Infinity : panel.near ? 60 : 200,
      lines: [
        ...(named ? [["", ({ name }) => name]] : []),
        [panel.x.brief ?? panel.x.label, (p) => withUnit(p.x, panel.x.unit)],
        [panel.y.brief ?? panel.y.label, (p) => withUnit(p.value, panel.y.unit, p.error)],
      ],
    },
    marks: [
      ...(panel.references ?? []).map((one) => referenceMark(one, theme)),
      ...selectedMarks(panel, about),
      ...drawn.flatMap(({ series, points, colour }) => marksOf(series, points, colour, panel)),
      ...nowMarks(panel, here, theme),
    ],
  });
  const known = told.filter(({ y }) => Number.isFinite(y));
  svg.numbers = svg.numbers.map((table) => ({ ...table, points: known }));
  if (panel.click === "step") {
    svg.style.cursor = "pointer";
    svg.addEventListener("click", () => svg.value && state.set({ step: svg.value.k, cracks: true, playing: false }));
  }
  return panel.corner ? withCorner(svg, theme, panel.corner, 54) : svg;
}
