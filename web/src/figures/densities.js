import * as Plot from "@observablehq/plot";
import { text } from "../text.js";
import { chart, decadesAround, logAxis, points, sampled, sideBySide } from "./chart.js";

const keys = { yy: "sigma_yy", xx: "sigma_xx", xy: "sigma_xy", hydrostatic: "sigma_hyd" };
const symbols = {
  sigma_yy: "\u03c3_{yy}",
  sigma_xx: "\u03c3_{xx}",
  sigma_xy: "\u03c3_{xy}",
  sigma_hyd: "\u03c3_{hyd}",
};
const order = ["all", "large", "small", "particle", "matrix"];

function setColour(theme, name) {
  return name === "all" ? theme.strong : theme.kindLine[{ matrix: 1, particle: 2, small: 3, large: 4 }[name]];
}

/** The statistics of the component that the picture shows, or of sigma_yy; its sets, particles only where they have no
    classes; over the mean of the sample or of each set. */
function of({ statistics }, state, theme) {
  const wanted = keys[state.get("component")],
    name = statistics[wanted] ? wanted : "sigma_yy";
  const { sets, normalised_by: by } = statistics[name];
  const own = state.get("norm") === "own" && Object.values(sets).some((d) => d.own_pdf);
  const shown = order.filter(
    (set) => sets[set]?.pdf && !(set === "particle" && (sets.large || sets.small)) && (!own || sets[set].own_pdf),
  );
  return {
    symbol: symbols[name],
    by,
    own,
    sets: shown.map((set) => ({
      set,
      colour: setColour(theme, set),
      d: sets[set],
      curve: own ? sets[set].own_pdf : sets[set].pdf,
    })),
  };
}

export const stressDensities = {
  id: "stress-pdf",
  title: "Stress of nodes by phase",
  wide: true,
  follows: ["component", "norm"],
  caption:
    "Probability density of the component shown in the picture, over the mean of the sample or of the phase, without the clamped rows. Over the mean of the phase: dotted (left), q-Gaussian fits; dashed (right), tails exp(\u2212s\u2009x) by maximum likelihood where the density falls from 0.1 to 0.001 of its peak.",
  choices: {
    norm: [
      "Over the mean of",
      [
        ["sample", "the sample"],
        ["own", "the phase"],
      ],
    ],
  },
  when: (_, { statistics }) => Object.values(statistics?.sigma_yy?.sets ?? {}).some((d) => d.pdf),
  key: ({ sample, state, theme }) => {
    const { own, sets } = of(sample, state, theme);
    return sets.map(({ set, colour, d }) => ({
      name: set,
      colour,
      values: (own
        ? [
            ["s", d.tail?.slope],
            ["q", d.q_gaussian?.q],
          ]
        : [
            ["mean", set === "all" ? null : d.mean_over_sample_mean],
            ["var", d.variance],
          ]
      ).filter(([, v]) => v),
    }));
  },
  draw({ sample, state, theme, width }) {
    const { symbol, by, own, sets } = of(sample, state, theme);
    if (sets.length === 0) return null;
    const label = `${symbol} / ${by === "mean" ? `\u27e8${symbol}\u27e9${own ? " of the phase" : ""}` : "r.m.s."}`;
    return sideBySide(
      width,
      [false, true].map((semilog) => (part) => densityChart(theme, sets, { label, semilog, own, width: part })),
    );
  },
};

function densityChart(theme, sets, { label, semilog, own, width }) {
  const lines = sets.map(({ set, colour, d, curve }) => ({
    set,
    colour,
    d,
    rows: points(curve).filter((p) => p.y > 0),
  }));
  const most = Math.max(...lines.flatMap(({ rows }) => rows.map((p) => p.y)));
  const least = most * (semilog ? 2e-5 : 6e-3),
    seen = lines.flatMap(({ rows }) => rows.filter((p) => p.y >= least).map((p) => p.x));
  const ends = [Math.min(...seen), Math.max(...seen)];
  const domain = semilog ? decadesAround(least, most) : [0, 1.05 * most];
  const inside = (list) => list.filter((p) => p.x >= ends[0] && p.x <= ends[1] && p.y >= domain[0] && p.y <= domain[1]);
  const fits = own
    ? lines.map(({ d, colour }) => ({ colour, rows: inside(semilog ? tail(d) : qGaussian(d, ends)) }))
    : [];
  return chart(theme, {
    width,
    height: 270,
    x: {
      label,
      domain: ends,
      ticks: Math.max(3, Math.round(width / 90)),
      tickFormat: (v) => text.number(v, 2).replace(/\.0$/, ""),
    },
    y: {
      ...(semilog ? logAxis("probability density", domain) : { label: "probability density", domain }),
      short: "density",
    },
    tips: { points: lines.flatMap(({ set, rows }) => inside(rows).map((p) => ({ ...p, name: set }))) },
    marks: [
      Plot.ruleX([1], { stroke: theme.soft, strokeDasharray: "2 3" }),
      ...lines.map(({ set, rows, colour }) =>
        Plot.line(inside(rows), {
          x: "x",
          y: "y",
          stroke: colour,
          strokeWidth: set === "all" ? 2.1 : 1.5,
          strokeOpacity: fits.length ? 0.55 : 1,
        }),
      ),
      ...fits.map(({ colour, rows }) =>
        Plot.line(rows, {
          x: "x",
          y: "y",
          stroke: colour,
          strokeWidth: 1.8,
          strokeDasharray: semilog ? "6 3" : "1.5 3",
        }),
      ),
    ],
  });
}

/** The fitted fall-off, holding as many nodes between its ends as were counted there. */
function tail({ tail: t, count }) {
  if (!t?.slope || t.low === undefined || t.high === undefined) return [];
  const s = t.slope.value,
    amplitude = ((t.count / count) * s) / (Math.exp(-s * t.low) - Math.exp(-s * t.high));
  return sampled(t.low, t.high, (x) => amplitude * Math.exp(-s * x));
}

/** The shape 1 + (q - 1) beta (x - centre)^2 to the power -1/(q - 1), scaled so that its sum over the line is 1. */
function qGaussian({ q_gaussian: g }, [from, to]) {
  if (!g?.q || !g.beta || !g.centre) return [];
  const [q, beta, centre] = [g.q.value, g.beta.value, g.centre.value];
  const shape = (x) => {
    const square = beta * (x - centre) ** 2;
    return Math.abs(q - 1) < 1e-6 ? Math.exp(-square) : Math.max(0, 1 + (q - 1) * square) ** (-1 / (q - 1));
  };
  // Substituting x = centre + tan(t)/sqrt(beta) brings the whole line into (-pi/2, pi/2).
  const n = 4000;
  let sum = 0;
  for (let k = 0; k < n; ++k) {
    const t = ((k + 0.5) / n - 0.5) * Math.PI;
    sum += (shape(centre + Math.tan(t) / Math.sqrt(beta)) * Math.PI) / n / Math.cos(t) ** 2 / Math.sqrt(beta);
  }
  return sampled(from, to, (x) => shape(x) / sum, {}, 240);
}
