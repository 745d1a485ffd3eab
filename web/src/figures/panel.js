import * as Plot from "@observablehq/plot";
import { plain, richSvg, s } from "../dom.js";
import { factorOf, text } from "../text.js";
import { chart, logAxis } from "./chart.js";
import { colourOf, dashOf } from "./colours.js";
import { inside, marksOf, pointsOf } from "./series.js";
import { withUnit } from "./tips.js";

const isWhole = (panel) =>
  !panel.x.unit &&
  panel.series.every(({ x }) => x.every(Number.isInteger)) &&
  panel.series.some(({ x }) => x.length > 1);

function axisOf({ label = null, unit, brief, log, low, high }, whole = false) {
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
        x1: (r) => Math.max(0, r.y - r.error),
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
  if (!now || here === null || !(here < now.x.length)) return [];
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

/** Which of the places of a reader's choices is nearest to a place of the pointer, as the eye sees it. */
function nearestOf({ now }, svg, { clientX, clientY }) {
  const [x, y] = ["x", "y"].map((axis) => svg.scale(axis)),
    pointer = new DOMPoint(clientX, clientY).matrixTransform(svg.firstChild.getScreenCTM().inverse());
  const away = now.x.map((at, k) => Math.hypot(x.apply(at) - pointer.x, now.y ? y.apply(now.y[k]) - pointer.y : 0));
  return away.reduce((best, distance, k) => (distance < away[best] || !(away[best] >= 0) ? k : best), 0);
}

/** The state of the page that is at a place among those stored, or next to it. */
const shownAt = (sample, place) => sample.stateAt?.(place) ?? Math.min(place, sample.snapshotCount - 1);

/** A click goes to the state, or the step, whose place is nearest. */
function answerClicks(svg, panel, { state, sample, first = 0 }) {
  const toStep = panel.click === "step";
  if (!panel.now || (!toStep && state.get("snapshot") === undefined)) return;
  svg.style.cursor = "pointer";
  svg.addEventListener("click", (event) => {
    const place = nearestOf(panel, svg, event);
    if (toStep) state.set({ step: place, cracks: true, playing: false });
    else state.set({ snapshot: shownAt(sample, first + place), playing: false });
  });
}

/** The place of the grain that is selected, upright. */
function selectedMarks({ selected, x }, { sample, state, texture, theme }) {
  const g = selected ? state.get("selected") : null;
  if (g === null || g === undefined) return [];
  const at = sample.abscissaOf(g, selected, texture) / factorOf(x.unit);
  return inside(x, at) ? [Plot.ruleX([at], { stroke: theme.accent, strokeWidth: 2, className: "selected" })] : [];
}

/** A line across, an upright one, one through the origin, or a cross. */
function referenceMark({ x, y, slope, colour, line }, { x: across }, theme) {
  const options = { stroke: colourOf(theme, colour), strokeDasharray: dashOf(line) };
  if (slope !== undefined) {
    const ends = [across.low, across.high].map((at) => [at, slope * at]);
    return Plot.line(ends, { ...options, clip: true });
  }
  if (x !== undefined && y !== undefined)
    return Plot.dot([0], { x: () => x, y: () => y, symbol: "times", r: 4, stroke: options.stroke });
  return x === undefined ? Plot.ruleY([y], options) : Plot.ruleX([x], options);
}

/** Its words, over the curves; those of upright lines stand in rows. */
function notesOf({ references = [], x: across, y: up }, theme) {
  return references
    .filter(({ label, slope }) => label && slope === undefined)
    .map(({ x, y, label, colour }, row) => {
      const fill = colourOf(theme, colour);
      const note = { text: () => label, fill, stroke: theme.card, strokeWidth: 3, fontSize: 10.5 };
      if (x !== undefined && y !== undefined) return Plot.text([0], { x: () => x, y: () => y, dy: -9, ...note });
      if (y !== undefined)
        return Plot.text([0], { x: () => across.high, y: () => y, textAnchor: "end", dy: -6, ...note });
      const right = x > 0.6 * across.high + 0.4 * across.low;
      const side = { textAnchor: right ? "end" : "start", dx: right ? -4 : 4, dy: 5 + 13 * row };
      return Plot.text([0], { x: () => x, y: () => up.high, ...side, ...note });
    });
}

/** Lines of text in the upper left corner, on a patch of the card's colour. */
function withCorner(svg, theme, lines, left) {
  const wide = 12 + 6 * Math.max(...lines.map((line) => plain(line).length));
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
  const { theme, sample, here } = about;
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
        [panel.x.brief ?? panel.x.label ?? "", (p) => withUnit(p.x, panel.x.unit)],
        [panel.y.brief ?? panel.y.label, (p) => withUnit(p.value, panel.y.unit, p.error)],
      ],
    },
    marks: [
      ...(panel.references ?? []).map((one) => referenceMark(one, panel, theme)),
      ...selectedMarks(panel, about),
      ...drawn.flatMap(({ series, points, colour }) => marksOf(series, points, colour, panel, theme)),
      ...notesOf(panel, theme),
      ...nowMarks(panel, here, theme),
    ],
  });
  const known = told.filter(({ y }) => Number.isFinite(y));
  svg.numbers = svg.numbers.map((table) => ({ ...table, points: known }));
  answerClicks(svg, panel, about);
  return panel.corner ? withCorner(svg, theme, panel.corner, 54) : svg;
}
