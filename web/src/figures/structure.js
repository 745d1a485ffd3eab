import * as Plot from "@observablehq/plot";
import { materialLine, pairColour } from "../theme.js";
import { text } from "../text.js";
import { chart } from "./chart.js";
import { withUnit } from "./tips.js";

/** Rows of the coordination figure: all; X-Y = Y neighbours of an X grain; X-ANY. */
function coordinationRows(sample, texture, theme) {
  const names = sample.materials.map((m) => m.name);
  const rows = [];
  const add = (name, label, colour) => {
    const estimate = texture.coordination[name];
    if (estimate) rows.push({ label, colour, y: estimate.value, error: estimate.error ?? 0 });
  };
  add("all", "all", theme.strong);
  names.forEach((name, m) => {
    if (names.length > 1) add(`${name}-ANY`, `${name}\u2013any`, materialLine(theme, m));
  });
  names.forEach((x, a) =>
    names.forEach((y, b) => {
      const type = sample.types.find((t) => !t.wall && t.a === Math.min(a, b) && t.b === Math.max(a, b));
      if (names.length > 1) add(`${x}-${y}`, `${x}\u2013${y}`, pairColour(theme, type));
    }),
  );
  return rows;
}

export const coordination = {
  id: "coordination",
  title: "Coordination number z",
  caption: "Mean number of contacts per grain with its standard error; X\u2013Y counts the Y neighbours of an X grain.",
  when: (texture) => texture.coordination?.all,
  draw({ sample, texture, theme, width }) {
    const rows = coordinationRows(sample, texture, theme);
    const whiskers = rows.map((r) => ({
      ...r,
      low: r.y - r.error,
      high: r.y + r.error,
      note: text.withError(r.y, r.error),
    }));
    const top = Math.max(...whiskers.map((r) => r.high)) * (width < 420 ? 1.55 : 1.3);
    return chart(theme, {
      width,
      height: 34 * rows.length + 52,
      marginLeft: 92,
      gridTicks: [],
      x: { label: "z", domain: [0, top], ticks: 5 },
      y: { label: null, domain: rows.map((r) => r.label), padding: 0.34, ticks: undefined },
      tips: {
        points: rows.map((r) => ({ ...r, x: r.y, y: r.label })),
        by: "y",
        reach: 200,
        lines: [
          ["", ({ y }) => y],
          ["z", ({ x, error }) => withUnit(x, "", error)],
        ],
      },
      marks: [
        Plot.gridX({ stroke: theme.rule, strokeOpacity: 1, ticks: 5 }),
        Plot.barX(whiskers, { x: "y", y: "label", fill: "colour", fillOpacity: 0.82, rx: 1.5 }),
        Plot.ruleY(whiskers, { x1: "low", x2: "high", y: "label", stroke: theme.ink, strokeWidth: 1.5 }),
        Plot.text(whiskers, {
          x: "high",
          y: "label",
          dx: 7,
          textAnchor: "start",
          fill: theme.ink,
          text: (r) => r.note.value + (r.note.error && ` \u00b1 ${r.note.error}`),
        }),
      ],
    });
  },
};

export const contactNumbers = {
  id: "contact-numbers",
  title: "Contacts per grain",
  caption: "Fraction of grains by number of contacts with other grains.",
  when: (texture) => texture.coordination?.histogram?.length,
  draw({ texture, theme, width }) {
    const bars = texture.coordination.histogram.map((share, z) => ({ z, share: 100 * share }));
    return chart(theme, {
      width,
      height: 254,
      x: { label: "contacts", domain: bars.map((b) => b.z), padding: 0.2 },
      y: { label: "grains", unit: "%" },
      tips: { points: bars.map(({ z, share }) => ({ x: z, y: share })), reach: 200 },
      marks: [Plot.barY(bars, { x: "z", y: "share", fill: theme.strong, fillOpacity: 0.72, rx: 1.5 })],
    });
  },
};

export const rev = {
  id: "rev",
  title: "Representative volume",
  caption:
    "Solid fraction of windows at random positions: mean with standard error, band of one standard deviation. Dashed: whole sample without its border.",
  when: (texture) => texture.rev,
  draw({ texture, theme, width }) {
    const { area_share: share, mean, deviation, error } = texture.rev;
    const rows = share.map((a, k) => ({
      x: 100 * a,
      y: mean[k],
      error: error[k],
      low: mean[k] - error[k],
      high: mean[k] + error[k],
      under: mean[k] - deviation[k],
      over: mean[k] + deviation[k],
    }));
    const whole = texture.solid_fraction?.value;
    return chart(theme, {
      width,
      height: 254,
      x: { label: "window", unit: "% of the area", domain: [0, 100], ticks: 5 },
      y: { label: "solid fraction", nice: true, zero: false },
      tips: { points: rows },
      marks: [
        Plot.areaY(rows, { x: "x", y1: "under", y2: "over", fill: theme.strong, fillOpacity: 0.09 }),
        whole ? Plot.ruleY([whole], { stroke: theme.accent, strokeDasharray: "5 4" }) : null,
        Plot.ruleX(rows, { x: "x", y1: "low", y2: "high", stroke: theme.strong }),
        Plot.dot(rows, { x: "x", y: "y", fill: theme.strong, r: 2.6 }),
      ],
    });
  },
};

export const threshold = {
  id: "threshold",
  title: "Anisotropy by force",
  caption:
    "Signed a_{c} along the loading axis, for the contacts above and below a force threshold; bands: values for random orientations.",
  when: (texture) => texture.fabric?.threshold,
  key: ({ theme }) => [
    { name: "F > \u03be\u27e8F\u27e9", colour: theme.strong, values: [] },
    { name: "F < \u03be\u27e8F\u27e9", colour: theme.accent, values: [] },
  ],
  draw({ texture, theme, width }) {
    const {
      force,
      a_c_above: above,
      noise_above: noiseAbove,
      a_c_below: below,
      noise_below: noiseBelow,
    } = texture.fabric.threshold;
    const rows = (values, noise) =>
      force
        .map((x, k) => ({ x, y: values[k], noise: noise[k] }))
        .filter((r) => r.y !== null && r.noise !== null && r.noise < 0.6);
    const sets = [
      { name: "F > \u03be\u27e8F\u27e9", colour: theme.strong, rows: rows(above, noiseAbove) },
      { name: "F < \u03be\u27e8F\u27e9", colour: theme.accent, rows: rows(below, noiseBelow) },
    ];
    return chart(theme, {
      width,
      height: 254,
      x: { label: "\u03be" },
      y: { label: "a_{c}", nice: true },
      tips: { points: sets.flatMap(({ name, rows: list }) => list.map((p) => ({ ...p, name }))) },
      marks: [
        ...sets.map(({ rows: list, colour }) =>
          Plot.areaY(list, { x: "x", y1: (r) => -r.noise, y2: "noise", fill: colour, fillOpacity: 0.1 }),
        ),
        Plot.ruleY([0], { stroke: theme.soft }),
        ...sets.map(({ rows: list, colour }) => Plot.line(list, { x: "x", y: "y", stroke: colour, strokeWidth: 1.75 })),
      ],
    });
  },
};
