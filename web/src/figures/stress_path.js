import * as Plot from "@observablehq/plot";
import { chart, sideBySide } from "./chart.js";
import { withUnit } from "./tips.js";

/** The states with contacts and a texture, in order: { k, t } with k the number of the state from 1. */
function states(sample) {
  return sample.about.snapshots
    .map((snapshot, k) => ({ k: k + 1, t: snapshot.texture }))
    .filter(({ t }) => t?.fabric?.a_c);
}

const series = (list, of) =>
  list.map(({ k, t }) => ({ k, ...of(t) })).filter((p) => p.value !== undefined && p.value !== null);

const ratio = (t) => {
  const { pressure_Pa: p, deviator_Pa: q } = t.stress_details ?? {};
  return p > 0 ? { value: q / p } : {};
};

const shown = {
  coordination: [
    ["z", (t) => t.coordination?.all ?? {}, "strong"],
    ["without rattlers", (t) => t.coordination?.without_rattlers ?? {}, "weak"],
  ],
  anisotropy: [
    ["q/p", ratio, "accent"],
    ["a_{c}, all", (t) => t.fabric.a_c_signed ?? {}, "soft"],
    ["a_{c}, strong", (t) => t.fabric.sets?.strong?.a_c_signed ?? {}, "strong"],
    ["a_{c}, weak", (t) => t.fabric.sets?.weak?.a_c_signed ?? {}, "weak"],
  ],
};

function panel(theme, state, list, lines, label, width) {
  const data = lines
    .map(([name, of, colour]) => ({ name, colour: theme[colour], rows: series(list, of) }))
    .filter(({ rows }) => rows.length);
  const here = state.get("snapshot") + 1;
  const last = data.map(({ name, colour, rows }) => ({ name, colour, k: rows.at(-1).k, value: rows.at(-1).value }));
  spread(last, data);
  const points = data.flatMap(({ name, rows }) => rows.map(({ k, value, error }) => ({ x: k, y: value, error, name })));
  const whiskers = data.flatMap(({ colour, rows }) =>
    rows.filter((r) => r.error > 0).map((r) => ({ ...r, colour, low: r.value - r.error, high: r.value + r.error })),
  );
  return chart(theme, {
    width,
    height: 236,
    marginRight: 96,
    x: { label: "stored state", ticks: 5, tickFormat: (v) => (Number.isInteger(v) ? String(v) : "") },
    y: { label, nice: true },
    tips: {
      points,
      lines: [
        ["", ({ name }) => name],
        ["stored state", ({ x }) => String(x)],
        ["", ({ y, error }) => withUnit(y, "", error)],
      ],
    },
    marks: [
      Plot.ruleX([here], { stroke: theme.accent, strokeWidth: 1.25 }),
      Plot.ruleX(whiskers, { x: "k", y1: "low", y2: "high", stroke: "colour", strokeOpacity: 0.6 }),
      ...data.flatMap(({ rows, colour }) => [
        Plot.line(rows, { x: "k", y: "value", stroke: colour, strokeWidth: 1.5 }),
        Plot.dot(rows, { x: "k", y: "value", fill: colour, r: 2.4 }),
      ]),
      Plot.text(last, { x: "k", y: "at", text: "name", fill: "colour", textAnchor: "start", dx: 9 }),
    ],
  });
}

/** Names at the ends of lines, kept at least a line of text apart. */
function spread(labels, data) {
  const values = data.flatMap(({ rows }) => rows.map((r) => r.value));
  const apart = (Math.max(...values) - Math.min(...values)) * 0.085;
  let below = -Infinity;
  for (const label of [...labels].sort((a, b) => a.value - b.value)) {
    label.at = Math.max(label.value, below + apart);
    below = label.at;
  }
}

export const stressPath = {
  id: "stress-path",
  title: "Stress path",
  wide: true,
  follows: true,
  caption:
    "Stored states in order, with standard errors: coordination number; signed a_{c} of the contacts along the loading axis, and the stress ratio q/p.",
  when: (texture, sample) => states(sample).length > 2,
  draw({ sample, state, theme, width }) {
    const list = states(sample);
    return sideBySide(width, [
      (part) => panel(theme, state, list, shown.coordination, "contacts per grain", part),
      (part) => panel(theme, state, list, shown.anisotropy, "anisotropy of contacts and stress", part),
    ]);
  },
};
