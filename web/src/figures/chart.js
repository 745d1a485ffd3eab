import * as Plot from "@observablehq/plot";
import { richSvg, s } from "../dom.js";
import { superscript, text } from "../text.js";
import { tipMarks } from "./tips.js";

const worded = ({ unit, short, ...axis }) => (unit ? { ...axis, label: `${axis.label}, ${unit}` } : axis);

/** A chart in the page's manner: thin grid, no frame, labels along the axes, symbols with subscripts; `tips` (tips.js)
    are the points whose numbers the pointer shows. An axis may have a `unit`, and a `short` name
    for tips. */
export function chart(theme, options) {
  const svg = drawn(theme, options),
    most = Math.max(
      ...[...svg.querySelectorAll('[aria-label^="y-axis tick label"] text')].map((tick) => tick.textContent.length),
    );
  // Room for more than three digits beside the axis.
  return most > 3 && options.marginLeft === undefined
    ? drawn(theme, { ...options, marginLeft: 50 + wideDigit * (most - 3) })
    : svg;
}

const wideDigit = 7; // px

function drawn(theme, { width, height = 250, x = {}, y = {}, marks, tips = null, marginLeft = 50, ...rest }) {
  const svg = Plot.plot({
    width,
    height,
    marginLeft,
    marginRight: 14,
    marginTop: 12,
    marginBottom: 42,
    style: { fontFamily: theme.font, fontSize: "11.5px", background: "none", color: theme.soft },
    x: { labelAnchor: "center", labelArrow: "none", labelOffset: 36, tickSize: 0, tickPadding: 7, ...worded(x) },
    y: {
      labelAnchor: "center",
      labelArrow: "none",
      labelOffset: marginLeft - 6,
      tickSize: 0,
      tickPadding: 7,
      ticks: 5,
      ...worded(y),
    },
    ...rest,
    marks: [
      Plot.gridY({
        stroke: theme.rule,
        strokeOpacity: 1,
        ticks: rest.gridTicks ?? (y.type === "log" ? decades(y.domain) : 5),
      }),
      ...marks,
      ...(tips ? tipMarks(theme, tips, { x, y }) : []),
    ],
  });
  // A chart within an SVG hears the pointer only where something is.
  if (tips) svg.prepend(s("path", { d: `M0,0h${width}v${height}h${-width}Z`, fill: "none", "pointer-events": "all" }));
  for (const tick of svg.querySelectorAll('[aria-label$="axis tick label"] text'))
    tick.textContent = tick.textContent.replace(/,(?=\d{3})/g, "\u202f"); // as counts are written elsewhere
  svg.removeAttribute("class");
  svg.querySelectorAll("style").forEach((style) => style.remove());
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.numbers = tips ? [{ x: wordsOf(x), y: wordsOf(y), points: tips.points }] : [];
  return richSvg(svg);
}

const wordsOf = ({ label, short, unit }) => [short ?? label ?? "", unit].filter(Boolean).join(", ");

export function decades([low, high]) {
  const list = [];
  for (let k = Math.ceil(Math.log10(low) - 1e-9); k <= Math.log10(high) + 1e-9; ++k) list.push(10 ** k);
  return list;
}

/** A logarithmic axis with powers of ten; where it holds one alone, with twice and five times them too. */
export function logAxis(label, domain) {
  const whole = decades(domain),
    finer = decades([domain[0] / 10, domain[1]])
      .flatMap((v) => [v, 2 * v, 5 * v])
      .filter((v) => v >= domain[0] && v <= domain[1]);
  return {
    type: "log",
    domain,
    label,
    ticks: whole.length > 1 ? whole : finer,
    tickFormat: (v) => {
      const k = Math.round(Math.log10(v));
      if (Math.abs(v / 10 ** k - 1) > 1e-9) return text.number(v, 1);
      return k === 0 ? "1" : k === -1 ? "0.1" : `10${superscript(k)}`;
    },
  };
}

/** Charts side by side as one SVG, or one below the other where there is little room. */
export function sideBySide(width, draw, gap = 18) {
  const narrow = width < 270 * draw.length;
  const part = narrow ? width : (width - gap) / draw.length;
  const parts = draw.map((f) => f(part));
  const heights = parts.map((p) => p.viewBox.baseVal.height);
  const height = narrow ? heights.reduce((a, b) => a + b, 0) : Math.max(...heights);
  const whole = s("svg", { viewBox: `0 0 ${width} ${height}`, width, height });
  let x = 0,
    y = 0;
  parts.forEach((p, k) => {
    p.setAttribute("x", x);
    p.setAttribute("y", y);
    if (narrow) y += heights[k];
    else x += part + gap;
    whole.append(p);
  });
  whole.numbers = parts.flatMap((p) => p.numbers ?? []);
  const style = parts[0].getAttribute("style");
  if (style) whole.setAttribute("style", style);
  for (const name of ["font-family", "font-size", "fill", "text-anchor"])
    if (parts[0].hasAttribute(name)) whole.setAttribute(name, parts[0].getAttribute(name));
  return whole;
}

/** Points of a texture's curve as objects; those without a value are left out. */
export function points(curve, more = {}) {
  return curve.x
    .map((x, k) => ({ x, y: curve.y[k], error: curve.error?.[k] ?? null, ...more }))
    .filter((p) => p.x !== null && p.y !== null);
}

/** A function sampled between two ends. */
export function sampled(from, to, f, more = {}, count = 80) {
  return Array.from({ length: count + 1 }, (_, k) => {
    const x = from + ((to - from) * k) / count;
    return { x, y: f(x), ...more };
  });
}
