import { label, s } from "./dom.js";
import { histogram } from "./field/scale.js";
import { prefixOf, text } from "./text.js";

/** The colours alone. */
export function bar(palette, x, y, length, height) {
  const steps = 96;
  return s(
    "g",
    {},
    Array.from({ length: steps }, (_, k) =>
      s("rect", {
        x: x + (k * length) / steps,
        y,
        width: length / steps + 0.6,
        height,
        fill: palette((k + 0.5) / steps),
      }),
    ),
  );
}

/** A bar 64 high with the histogram of the values (`scale.order`) on it, round numbers below, and what lies beyond its
    ends; `mean` is marked where it is given. */
export function colourBar({ title, unit, scale, palette, theme, length, mean = null, at = null }) {
  const top = 24,
    height = 24,
    bins = Math.round(length / 3);
  const counts = histogram(scale.order, scale, bins),
    most = Math.max(1, ...counts);
  const peaks = counts
    .map((n, k) => `L${(k * length) / bins},${top + height - (n / most) * (height - 2)}h${length / bins}`)
    .join("");
  const { factor, unit: prefixed } = prefixOf(Math.max(Math.abs(scale.low), Math.abs(scale.high)), unit);
  const head = unit ? `${title}, ${prefixed}` : title;
  const group = s(
    "g",
    {},
    label(0, 8, head, null, { fill: theme.ink }),
    bar(palette, 0, top, length, height),
    s("path", {
      d: `M0,${top + height}${peaks}V${top + height}Z`,
      fill: theme.card,
      "fill-opacity": 0.55,
      stroke: theme.ink,
      "stroke-width": 0.6,
      "stroke-opacity": 0.6,
    }),
  );
  const share = (v) => (v < 5e-5 ? "" : `${text.number(100 * v, 2)}\u202f%`);
  const [below, above] = [share(scale.below), share(scale.above)];
  const headEnd = Math.max(82, 12 + 6 * head.replace(/_\{([^}]*)\}/g, "$1").length),
    beside = headEnd + (below ? 60 : 0) + (above ? 60 : 0) > length;
  if (below) group.append(beside ? label(length + 6, 37, `\u25c2 ${below}`) : label(headEnd, 8, `\u25c2 ${below}`));
  if (above)
    group.append(
      beside ? label(length + 6, below ? 52 : 37, `\u25b8 ${above}`) : label(length, 8, `${above} \u25b8`, "end"),
    );
  const places = at ?? ticks(scale, length),
    write = scale.symlog ? (v) => text.number(v / factor, 2) : evenly(places, factor);
  for (const v of places) {
    const x = scale.of(v) * length;
    group.append(
      s("line", { x1: x, x2: x, y1: top + height, y2: top + height + 4, stroke: theme.soft }),
      label(within(x, write(v), length), top + height + 12, write(v), "middle"),
    );
  }
  if (mean !== null) {
    const x = scale.of(mean) * length;
    group.append(
      s("path", { d: `M${x},${top - 1}l-3.5,-5h7Z`, fill: theme.accent }),
      length > 280 ? label(x + 7, top - 5, "mean", null, { fill: theme.accent, "font-size": 10.5 }) : "",
    );
  }
  return group;
}

/** The middle of a label that ends at the bar's ends at the latest. */
function within(x, words, length) {
  const half = 3.4 * words.length;
  return Math.min(length - half + 6, Math.max(half, x));
}

/** All with as many decimals as their distance needs. */
function evenly(places, factor) {
  const order = [...places].sort((a, b) => a - b),
    step = Math.min(...order.slice(1).map((v, k) => v - order[k])) / factor;
  if (!Number.isFinite(step)) return (v) => text.number(v / factor, 2);
  const decimals = Math.min(6, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
  return (v) => (v === 0 ? "0" : (v / factor).toFixed(decimals).replace("-", "\u2212"));
}

/** Round values, at least 36 pixels apart. */
function ticks(scale, length) {
  const candidates = new Set([0]);
  if (scale.symlog) {
    const reach = Math.max(Math.abs(scale.low), Math.abs(scale.high));
    for (let p = Math.ceil(Math.log10(reach)); p > Math.log10(reach) - 3; --p)
      for (const f of [1, 3]) for (const sign of [1, -1]) candidates.add(sign * f * 10 ** p);
  } else {
    const wanted = ((scale.high - scale.low) * 62) / length,
      power = 10 ** Math.floor(Math.log10(wanted));
    const steps = [0.5, 1, 2, 5, 10].map((f) => f * power),
      k = steps.findIndex((v) => v >= wanted);
    const severalFit = Math.floor(scale.high / steps[k]) > Math.ceil(scale.low / steps[k]),
      step = severalFit ? steps[k] : steps[k - 1];
    for (let k = Math.ceil(scale.low / step); k * step <= scale.high; ++k) candidates.add(k * step);
  }
  const kept = [];
  for (const v of [...candidates]
    .filter((c) => c >= scale.low && c <= scale.high)
    .sort((a, b) => (Math.abs(a) > Math.abs(b) && a !== 0 && b !== 0 ? -1 : a === 0 ? -1 : 1)))
    if (kept.every((other) => Math.abs(scale.of(other) - scale.of(v)) * length >= 36)) kept.push(v);
  return kept;
}
