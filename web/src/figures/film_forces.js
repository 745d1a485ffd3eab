import * as Plot from "@observablehq/plot";
import { prefixOf, text } from "../text.js";
import { contactName } from "../film/tooltip.js";
import { chart } from "./chart.js";

const sets = [
  [false, "present"],
  [true, "may be absent"],
];
const colourOf = (theme, uncertain) => (uncertain ? theme.tension : theme.strong);

export const rankedForces = {
  id: "film-forces",
  title: "Contact forces \u00b1 s.e.",
  wide: true,
  follows: ["component"],
  caption:
    "Peak-to-peak forces, ranked, with one standard error on either side. May be absent: contacts that are present with a probability below 95\u202f%; about as many present contacts are missed.",
  choices: {
    component: [
      "",
      [
        ["fn", "F_{n}"],
        ["ft", "F_{t}"],
      ],
    ],
  },
  when: (_, film) => film.hasForces,
  key: ({ sample, theme }) => {
    const counts = [0, 0];
    for (let c = 0; c < sample.contacts.count; ++c) ++counts[Number(sample.isUncertain(c))];
    return sets
      .filter(([u]) => counts[Number(u)] > 0)
      .map(([u, name]) => ({
        name: `${text.count(counts[Number(u)])} ${name}`,
        colour: colourOf(theme, u),
        values: [],
      }));
  },
  draw({ sample, state, theme, width }) {
    const name = state.get("component"),
      force = sample.contacts[name],
      error = sample.contacts[`${name}_error`];
    if (!force) return null;
    const order = Array.from(force.keys())
      .filter((c) => Number.isFinite(force[c]))
      .sort((a, b) => force[b] - force[a]);
    const { factor, unit } = prefixOf(
      force.reduce((most, f) => Math.max(most, Math.abs(f)), 0),
      force.unit,
    );
    const rows = order.map((c, k) => ({
      x: k + 1,
      y: force[c] / factor,
      error: (error?.[c] ?? 0) / factor,
      colour: colourOf(theme, sample.isUncertain(c)),
      name: contactName(sample, c),
    }));
    return chart(theme, {
      width,
      height: 262,
      x: { label: "rank", domain: [0, rows.length + 1], ticks: 6 },
      y: { label: `F_{${name[1]}}`, unit, nice: true },
      tips: { points: rows },
      marks: [
        Plot.ruleY([0], { stroke: theme.soft, strokeWidth: 0.8 }),
        Plot.ruleX(rows, {
          x: "x",
          y1: (r) => r.y - r.error,
          y2: (r) => r.y + r.error,
          stroke: "colour",
          strokeOpacity: 0.38,
          strokeWidth: Math.min(1.4, Math.max(0.6, width / rows.length / 2)),
        }),
        Plot.dot(rows, { x: "x", y: "y", fill: "colour", r: rows.length > 300 ? 1.2 : 2 }),
      ],
    });
  },
};

export const certainty = {
  id: "film-certainty",
  title: "Signal-to-noise ratio of forces",
  caption: "Number of contacts by F_{n} over its standard error; the last bar includes all larger values.",
  when: (_, film) => film.hasForces && film.contacts.fn_error,
  draw({ sample, theme, width }) {
    const { fn, fn_error: error } = sample.contacts,
      ratio = Array.from(fn, (f, c) => ({ c, v: f / error[c] })).filter(({ v }) => Number.isFinite(v));
    if (ratio.length === 0) return null;
    const sorted = ratio.map(({ v }) => v).sort((a, b) => a - b),
      high = Math.max(4, sorted[Math.floor(0.98 * (sorted.length - 1))]),
      low = Math.min(0, Math.max(-6, sorted[0]));
    const step = [0.5, 1, 2, 5, 10, 20, 50, 100].find((v) => (high - low) / v <= 36) ?? 200,
      first = Math.floor(low / step),
      bins = Math.ceil(high / step) - first;
    const counts = sets.map(() => new Array(bins).fill(0));
    for (const { c, v } of ratio)
      ++counts[Number(sample.isUncertain(c))][Math.min(bins - 1, Math.max(0, Math.floor(v / step) - first))];
    const bars = sets
      .flatMap(([uncertain, name], k) =>
        counts[k].map((n, b) => ({
          x1: (first + b) * step,
          x2: (first + b + 1) * step,
          y1: k ? counts[0][b] : 0,
          y2: (k ? counts[0][b] : 0) + n,
          colour: colourOf(theme, uncertain),
          name,
        })),
      )
      .filter((b) => b.y2 > b.y1);
    return chart(theme, {
      width,
      height: 262,
      x: { label: "F_{n} / standard error", ticks: 6 },
      y: { label: "contacts" },
      tips: {
        points: bars.map((b) => ({ ...b, x: (b.x1 + b.x2) / 2, y: b.y2 })),
        reach: 200,
        lines: [
          ["F_{n} / s.e.", (b) => `${text.number(b.x1, 2)} to ${text.number(b.x2, 2)}`],
          ["", (b) => `${text.count(b.y2 - b.y1)} contacts, ${b.name}`],
        ],
      },
      marks: [
        Plot.rect(bars, { x1: "x1", x2: "x2", y1: "y1", y2: "y2", fill: "colour", fillOpacity: 0.75, inset: 0.5 }),
        Plot.ruleX([0], { stroke: theme.soft, strokeWidth: 0.8 }),
      ],
    });
  },
};
