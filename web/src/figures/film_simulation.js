import * as Plot from "@observablehq/plot";
import { s } from "../dom.js";
import { materialLine } from "../theme.js";
import { prefixOf, text } from "../text.js";
import { chart } from "./chart.js";
import { cumulativeChart } from "./distributions.js";
import { grainName, known, sourceName } from "./film_grains.js";

/** How the film agrees with the simulation that is chosen, by set. */
const agreement = ({ declared }, state) => declared.in("agreement").in(`simulation_${state.get("companion")}`).tree;

/** The two to compare, as pressures over their means or in Pa: { rows, factor, shown (the unit), about }. */
function pairs(film, state, theme) {
  const simulation = film.stresses[`simulation_${state.get("companion")}`],
    own = film.stresses.film,
    norm = state.get("over") === "mean";
  if (!simulation) return null;
  const { factor, unit: shown } = norm
    ? { factor: 1, unit: "" }
    : prefixOf(Math.max(Math.abs(own.mean), Math.abs(simulation.mean)), own.sigma_hyd.unit);
  const value = (source, g) => (norm ? source.sigma_norm[g] : -source.sigma_hyd[g] / factor);
  const unit = norm ? Math.abs(own.mean) : factor,
    rows = [];
  for (let g = 0; g < film.count; ++g) {
    const row = {
      x: value(simulation, g),
      y: value(own, g),
      error: (film.grains.error?.[g] || 0) / unit,
      colour: materialLine(theme, film.grains.material[g]),
      counts: film.grains.considered?.[g] !== 0,
      name: grainName(film, g),
    };
    if (Number.isFinite(row.x) && Number.isFinite(row.y)) rows.push(row);
  }
  return { rows, factor, shown, norm, about: agreement(film, state) };
}

const inOrder = ({ value, error }) => {
  const t = text.withError(value, error);
  return t.value + (t.error && ` \u00b1 ${t.error}`);
};

export const againstSimulation = {
  id: "film-simulation",
  title: "Film against simulation",
  follows: ["companion", "over"],
  caption:
    "Every grain with the film\u2019s standard error, pale near the border; line: equality; r and the difference exclude the border. Largest load: includes the stress at the smallest load, which no film shows. " +
    "On virtual films a simulation from positions alone reaches a correlation of about 0.4 to 0.5: individual contact forces depend on the friction history of filling and " +
    "loading, and this history is lost.",
  choices: {
    companion: [
      "",
      [
        ["peak_to_peak", "Peak to peak"],
        ["state", "Largest load"],
      ],
    ],
    over: [
      "",
      [
        ["mean", "\u03c3_{norm}"],
        ["unit", "Pa"],
      ],
    ],
  },
  when: (_, film) => film.hasSimulation,
  key: ({ sample, state, theme }) => {
    const about = agreement(sample, state);
    return sample.materials.map(({ name }, m) => ({
      name,
      colour: materialLine(theme, m),
      values: about[name]?.correlation ? [["r", about[name].correlation]] : [],
    }));
  },
  draw({ sample, state, theme, width }) {
    const data = pairs(sample, state, theme);
    if (!data || data.rows.length === 0) return null;
    const {
      rows,
      shown: unit,
      norm,
      factor,
      about: { all },
    } = data;
    const most = 1.04 * Math.max(...rows.flatMap((r) => [r.x, r.y])),
      least = Math.min(0, ...rows.flatMap((r) => [r.x, r.y]));
    const label = norm ? "\u03c3_{norm}" : "\u2212\u03c3_{hyd}",
      domain = [least, most];
    const height = Math.round(Math.min(380, Math.max(240, width - 10)));
    const svg = chart(theme, {
      width,
      height,
      x: { label: `simulation, ${label}`, unit, domain, ticks: 5 },
      y: { label: `film, ${label}`, unit, domain },
      tips: { points: rows, by: "both" },
      marks: [
        Plot.line(
          [
            [least, least],
            [most, most],
          ],
          { stroke: theme.fit, strokeWidth: 1.2, strokeDasharray: "6 3" },
        ),
        Plot.ruleX(rows, {
          x: "x",
          y1: (r) => r.y - r.error,
          y2: (r) => r.y + r.error,
          stroke: "colour",
          strokeOpacity: 0.35,
          clip: true,
        }),
        ...[true, false].map((counts) =>
          Plot.dot(
            rows.filter((r) => r.counts === counts),
            { x: "x", y: "y", fill: "colour", fillOpacity: counts ? 0.8 : 0.3, r: rows.length > 300 ? 1.6 : 2.2 },
          ),
        ),
      ],
    });
    return all?.correlation
      ? withCorner(svg, theme, [
          `r = ${inOrder(all.correlation)}`,
          `r.m.s. difference ${norm ? text.number(all.rms_sigma_norm, 2) : text.number(all.rms_Pa / factor, 2)}${unit && `\u202f${unit}`}`,
        ])
      : svg;
  },
};

/** Lines of text in the upper left corner, on a patch of the card's colour. */
function withCorner(svg, theme, lines) {
  const wide = 12 + 6 * Math.max(...lines.map((line) => line.length));
  svg.append(
    s("rect", {
      x: 54,
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
      lines.map((line, k) => s("text", { x: 60, y: 28 + 16 * k }, line)),
    ),
  );
  return svg;
}

const setColours = (theme) => ({
  film: theme.strong,
  simulation_peak_to_peak: theme.accent,
  simulation_state: theme.mixedLine[1],
});

function sets(film, theme) {
  const colours = setColours(theme);
  return known(film)
    .map(([name]) => ({
      name: name === "film" ? "film" : `simulation, ${sourceName(name)}`,
      d: film.stresses[name].statistics,
      colour: colours[name],
    }))
    .filter(({ d }) => d.cumulative && d.count > 1);
}

export const stressTails = {
  id: "film-tails",
  title: "Tails of \u03c3_{norm}",
  caption:
    "P: survival function, the fraction of grains above \u03c3_{norm}, away from the border. Dashed: P_{0} exp[\u03b2(1 \u2212 \u03c3_{norm})], maximum likelihood.",
  when: (_, film) => known(film).some(([name]) => film.stresses[name].statistics.cumulative),
  key: ({ sample, theme }) =>
    sets(sample, theme).map(({ name, colour, d }) => ({
      name,
      colour,
      values: [
        ["P_{0}", d.P0],
        ["\u03b2", d.beta],
      ].filter(([, v]) => v),
    })),
  draw: ({ sample, theme, width }) =>
    cumulativeChart(theme, sets(sample, theme), {
      x: "\u03c3_{norm}",
      y: "P(\u03c3_{norm})",
      semilog: true,
      width,
      height: 330,
    }),
};
