import * as Plot from "@observablehq/plot";
import { richSvg } from "../dom.js";
import { text } from "../text.js";

/** What a saved figure is without. */
export const passing = ".passing";

const pointers = { x: Plot.pointerX, y: Plot.pointerY, both: Plot.pointer };

/** A number with its error and its unit; a whole one without error is a count. */
export function withUnit(value, unit, error) {
  const { value: v, error: e } =
    Number.isInteger(value) && !(error > 0) ? { value: text.count(value) } : text.withError(value, error);
  return `${v}${e ? ` \u00b1 ${e}` : ""}${unit ? `\u202f${unit}` : ""}`;
}

/** The lines of a tip from the axes: what it is of, where points have a name, x, and y with its error. */
function linesOf(points, { x, y }) {
  const named = points.some(({ name }) => name) ? [["", ({ name }) => name]] : [];
  return [
    ...named,
    [x.short ?? x.label, (p) => withUnit(p.x, x.unit)],
    [y.short ?? y.label, (p) => withUnit(p.y, y.unit, p.error)],
  ];
}

/** Which of its corners or edges a tip turns to a point, so that it stays over its chart. */
function anchorAt(x, y, { width, height }) {
  return [y < height / 2 ? "top" : "bottom", x < width / 3 ? "left" : x > (2 * width) / 3 ? "right" : null]
    .filter(Boolean)
    .join("-");
}

/** A ring around the point next to the pointer and its numbers beside it. `points` = [{ x, y, name, error }]; `by` is
    what the nearest is measured along; `reach` in pixels; `lines` = [[label, function from a point to words]] where
    they are not those of the axes. */
export function tipMarks(theme, { points, by = "x", reach = 40, lines = null }, axes) {
  const near = (options) => pointers[by]({ x: "x", y: "y", maxRadius: reach, ...options });
  const all = lines ?? linesOf(points, axes);
  const channels = Object.fromEntries(all.map(([label], k) => [`line${k}`, { value: (p) => p, label }]));
  const format = Object.fromEntries(all.map(([, words], k) => [`line${k}`, words]));
  return [
    Plot.dot(points, near({ r: 4.5, stroke: theme.accent, strokeWidth: 1.6, className: "passing" })),
    Plot.tip(
      points,
      near({
        channels,
        format: { x: false, y: false, ...format },
        fill: theme.card,
        stroke: theme.soft,
        strokeOpacity: 0.6,
        lineHeight: 1.3,
        lineWidth: 40,
        className: "passing",
        render(index, scales, values, dimensions, context, next) {
          for (const i of index) this.anchor = anchorAt(values.x[i], values.y[i], dimensions);
          const tip = richSvg(next(index, scales, values, dimensions, context));
          tip.setAttribute("color", theme.ink);
          return tip;
        },
      }),
    ),
  ];
}
