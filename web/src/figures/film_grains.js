import * as Plot from "@observablehq/plot";
import { stressColour } from "../film/overlay.js";
import { stressKey } from "../film/legend.js";
import { richSvg, s } from "../dom.js";
import { materialLine } from "../theme.js";
import { prefixOf } from "../text.js";
import { chart } from "./chart.js";

export const rankedStresses = {
  id: "film-stresses",
  title: "Grain stresses \u00b1 s.e.",
  caption:
    "Peak-to-peak pressure \u2212\u03c3_{hyd} of every grain, ranked, with one standard error on either side (pixel noise, position of the grain, lens blur, model).",
  when: (_, film) => film.stresses.film && film.grains.sigma_hyd,
  key: ({ sample, theme }) =>
    sample.materials.length > 1
      ? sample.materials.map(({ name }, m) => ({ name, colour: materialLine(theme, m), values: [] }))
      : [],
  draw({ sample, theme, width }) {
    const { sigma_hyd: sigma, error, material } = sample.grains;
    const order = Array.from(sigma.keys())
      .filter((g) => Number.isFinite(sigma[g]))
      .sort((a, b) => sigma[a] - sigma[b]);
    const { factor, unit } = prefixOf(
      sigma.reduce((most, v) => Math.max(most, Math.abs(v) || 0), 0),
      sigma.unit,
    );
    const rows = order.map((g, k) => ({
      x: k + 1,
      y: -sigma[g] / factor,
      error: (error?.[g] || 0) / factor,
      colour: materialLine(theme, material[g]),
      name: grainName(sample, g),
    }));
    return chart(theme, {
      width,
      height: 262,
      x: { label: "rank", domain: [0, rows.length + 1], ticks: 5 },
      y: { label: "\u2212\u03c3_{hyd}", unit, nice: true },
      tips: { points: rows },
      marks: [
        Plot.ruleY([0], { stroke: theme.soft, strokeWidth: 0.8 }),
        Plot.ruleX(rows, {
          x: "x",
          y1: (r) => r.y - r.error,
          y2: (r) => r.y + r.error,
          stroke: "colour",
          strokeOpacity: 0.5,
        }),
        Plot.dot(rows, { x: "x", y: "y", fill: "colour", r: rows.length > 300 ? 1.2 : 1.7 }),
      ],
    });
  },
};

/** "Grain 12, POM". */
export const grainName = ({ grains, materials }, g) =>
  `Grain ${grains.id?.[g] ?? g + 1}${materials.length > 1 ? `, ${materials[grains.material[g]].name}` : ""}`;

const sources = [
  ["film", "Film"],
  ["simulation_peak_to_peak", "Simulation, peak to peak"],
  ["simulation_state", "Simulation, largest load"],
];
/** "peak to peak", "largest load". */
export const sourceName = (source) =>
  sources
    .find(([name]) => name === source)[1]
    .replace("Simulation, ", "")
    .toLowerCase();
export const known = (film) => sources.filter(([name]) => film.stresses[name]);

/** Rectangle around all grains, in pixels of the film. */
function extent({ grains: { x, y, radius } }) {
  const ends = (v, sign) => v.reduce((most, c, g) => Math.max(most, sign * c + radius[g]), -Infinity);
  return { left: -ends(x, -1), right: ends(x, 1), top: -ends(y, -1), bottom: ends(y, 1) };
}

export const stressMaps = {
  id: "film-maps",
  title: "Experiment and simulation: \u03c3_{norm} of every grain",
  wide: true,
  caption:
    "Each normalised by its own mean, on one colour scale. A film shows the difference between two loads (peak to peak); the state at the largest load also includes the stress at the smallest load.",
  when: (_, film) => film.hasSimulation && film.count > 0,
  draw({ sample, theme, width }) {
    const shown = known(sample),
      columns = width < 200 * shown.length ? 1 : shown.length,
      gap = 16;
    const box = extent(sample),
      part = (width - gap * (columns - 1)) / columns,
      scale = (part - 2) / (box.right - box.left);
    const tall = 24 + (box.bottom - box.top) * scale + 2,
      rows = Math.ceil(shown.length / columns),
      height = rows * (tall + 10) + 52;
    const svg = s("svg", {
      viewBox: `0 0 ${width} ${height}`,
      width,
      height,
      "font-family": theme.font,
      "font-size": 11.5,
      fill: theme.soft,
    });
    shown.forEach(([name, title], k) => {
      const group = s(
        "g",
        { transform: `translate(${(k % columns) * (part + gap)} ${Math.floor(k / columns) * (tall + 10)})` },
        s("text", { x: 0, y: 12, fill: theme.ink, "font-weight": 600 }, title),
      );
      const disks = s("g", { stroke: theme.ink, "stroke-opacity": 0.35, "stroke-width": 0.6 }),
        { x, y, radius } = sample.grains;
      for (let g = 0; g < sample.count; ++g)
        disks.append(
          s("circle", {
            cx: (1 + (x[g] - box.left) * scale).toFixed(2),
            cy: (25 + (y[g] - box.top) * scale).toFixed(2),
            r: (radius[g] * scale).toFixed(2),
            fill: stressColour(sample, theme, sample.stresses[name].sigma_norm[g]),
          }),
        );
      group.append(disks);
      svg.append(group);
    });
    svg.append(
      s("g", { transform: `translate(1 ${height - 51})` }, stressKey(sample, theme, Math.min(260, width - 2))),
    );
    return richSvg(svg);
  },
};
