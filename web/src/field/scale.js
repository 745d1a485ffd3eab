import { drawn } from "../drawn.js";

/** Shares of the nodes that a colour scale may leave beyond each of its ends. */
export const clips = { all: 0, 0.1: 0.001, 1: 0.01, 5: 0.05 };

/** The one of them that the program takes of what is shown: "nodes" or "pixels". */
export const usualClip = (of) => Object.keys(clips).find((clip) => clips[clip] === drawn().beyond[of]);

/** Values of the nodes that count, in order. */
export function sorted(values, kind) {
  const kept = new Float32Array(values.length);
  let n = 0;
  for (let k = 0; k < values.length; ++k) if (kind[k] !== 0) kept[n++] = values[k];
  return kept.subarray(0, n).sort();
}

/** A scale from values to 0..1. `around`: "mean", "zero" (diverging, both arms equally long) or "ends" (sequential);
    symlog keeps the middle linear and squeezes the tails: asinh(v/linear)/asinh(reach/linear). `ends`: beyond which
    the share `clip` lies, where the program says it. */
export function makeScale(order, { around, symlog, clip, mean, ends }) {
  const n = order.length,
    at = (share) => order[Math.round(share * (n - 1))] ?? 0;
  let [low, high] = ends ?? [at(clip), at(1 - clip)];
  if (!(high > low)) [low, high] = [low - (Math.abs(low) || 1), high + (Math.abs(high) || 1)];
  const centre = around === "mean" ? mean : around === "zero" ? 0 : null;
  if (centre !== null) {
    const reach = Math.max(high - centre, centre - low) || 1;
    [low, high] = [centre - reach, centre + reach];
  }
  const pivot = centre ?? (low < 0 && high > 0 ? 0 : low);
  const linear = 0.04 * (high - low);
  const bend = symlog ? (v) => Math.asinh((v - pivot) / linear) : (v) => v;
  const unbend = symlog ? (t) => pivot + linear * Math.sinh(t) : (t) => t;
  const first = bend(low),
    last = bend(high);
  return {
    low,
    high,
    centre,
    symlog,
    below: share(order, low),
    above: 1 - share(order, high, true),
    of: (v) => (bend(v) - first) / (last - first),
    value: (t) => unbend(first + t * (last - first)),
  };
}

/** From one end to the other, of values in order. */
export function linearScale(order, [low, high]) {
  return {
    order,
    low,
    high,
    symlog: false,
    below: share(order, low),
    above: 1 - share(order, high, true),
    of: (v) => (v - low) / (high - low),
  };
}

/** Share of the values below (or not above) a limit. */
function share(order, limit, including = false) {
  let from = 0,
    to = order.length;
  while (from < to) {
    const middle = (from + to) >> 1;
    if (order[middle] < limit || (including && order[middle] === limit)) from = middle + 1;
    else to = middle;
  }
  return order.length ? from / order.length : 0;
}

/** How many of the values fall into each of `bins` equal parts of the scale, each shared between the two whose middles
    are next to it (or coded values would make a comb); what lies beyond is left out. */
export function histogram(order, scale, bins) {
  const counts = new Array(bins).fill(0);
  for (const v of order) {
    const at = scale.of(v) * bins;
    if (!(at >= 0 && at < bins)) continue;
    const k = Math.floor(at - 0.5),
      part = at - 0.5 - k;
    counts[Math.max(0, k)] += 1 - part;
    counts[Math.min(bins - 1, k + 1)] += part;
  }
  return counts;
}
