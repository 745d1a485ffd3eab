import * as Plot from "@observablehq/plot";
import { prefixOf } from "../text.js";
import { chart, sideBySide } from "./chart.js";

const stageOf = (sample, state) => sample.stages[sample.about.frames[state.get("frame")].stage];

/** Walls along a test, row by row: width and height of the sample, m; pressures on its sides over their sum. */
function walls(history) {
  const of = (name) => history[name]?.values;
  const [l, r, b, t] = ["left", "right", "bottom", "top"].map((side) => of(`${side}_position`));
  if (!l || !r || !b || !t || l.length < 3) return null;
  const mean = (one, other, k) => 0.5 * ((of(`${one}_force`)?.[k] ?? 0) + (of(`${other}_force`)?.[k] ?? 0));
  return Array.from(l, (_, k) => {
    const width = r[k] - l[k], height = t[k] - b[k];
    return { width, height, x: mean("left", "right", k) / height, y: mean("bottom", "top", k) / width, shear: of("top_shear_force")?.[k] ?? 0, normal: of("top_force")?.[k] ?? 0 };
  });
}

/** What a stage was strained by: { label, of: row -> strain, % } of the shear, or of the side that moves farthest. */
function strainOf(history, rows) {
  if (history.shear_strain) return { label: "shear strain", unit: "", of: (k) => Math.abs(history.shear_strain.values[k]) };
  const first = rows[0], last = rows.at(-1), x = 1 - last.width / first.width, y = 1 - last.height / first.height;
  if (Math.max(Math.abs(x), Math.abs(y)) < 2e-3) return null;
  const along = Math.abs(y) >= Math.abs(x) ? "height" : "width";
  return { label: `strain of the ${along}`, unit: "%", of: (k) => 100 * (1 - rows[k][along] / first[along]) };
}

function curvesOf(stage) {
  const rows = stage.history && walls(stage.history), strain = rows && strainOf(stage.history, rows);
  if (!strain) return null;
  const sheared = Boolean(stage.history.shear_strain), area = rows[0].width * rows[0].height;
  const ratio = (row) => (sheared ? (row.normal > 0 ? Math.abs(row.shear) / row.normal : null) : row.x + row.y > 0 ? Math.abs(row.y - row.x) / (row.x + row.y) : null);
  return {
    strain, ratioLabel: sheared ? "friction, shear over normal force" : "q/p by the forces on the sides",
    ratio: rows.map((row, k) => ({ x: strain.of(k), y: ratio(row) })).filter(({ y }) => y !== null && y < 2),
    volume: rows.map((row, k) => ({ x: strain.of(k), y: 100 * (1 - (row.width * row.height) / area) })),
  };
}

/** The curve thinned to means over about as many stretches as can be told apart. */
function smooth(points, most = 160) {
  const step = Math.ceil(points.length / most);
  if (step < 3) return points;
  const result = [];
  for (let k = 0; k < points.length; k += step) {
    const part = points.slice(k, k + step), mean = (key) => part.reduce((sum, p) => sum + p[key], 0) / part.length;
    result.push({ x: mean("x"), y: mean("y") });
  }
  return result;
}

function panel(theme, strain, points, y, width) {
  const curve = smooth(points);
  return chart(theme, {
    width, height: 236, marginLeft: 60,
    x: { label: strain.label, unit: strain.unit, ticks: 5 }, y, tips: { points: curve },
    marks: [
      ...(curve === points ? [] : [Plot.line(points, { x: "x", y: "y", stroke: theme.weak, strokeOpacity: 0.35, strokeWidth: 0.7 })]),
      Plot.line(curve, { x: "x", y: "y", stroke: theme.strong, strokeWidth: 1.7 }),
    ],
  });
}

export const testCurves = {
  id: "test-curves", title: "Curves of the test", wide: true, follows: true,
  caption: "Of the stage shown, from the forces on its sides and their places: stress ratio and volumetric strain (compaction positive) against strain; thin: every sample, line: means.",
  when: (texture, sample) => sample.stages.some((stage) => curvesOf(stage)),
  draw({ sample, state, theme, width }) {
    const curves = curvesOf(stageOf(sample, state));
    if (!curves) return null;
    return sideBySide(width, [
      (part) => panel(theme, curves.strain, curves.ratio, { label: curves.ratioLabel, nice: true }, part),
      (part) => panel(theme, curves.strain, curves.volume, { label: "volumetric strain", unit: "%", nice: true }, part),
    ]);
  },
};

export const discharge = {
  id: "discharge", title: "Discharge", follows: true,
  caption: "Mass of the grains that have passed the height that the recipe counts below; its slope is the rate of discharge.",
  when: (texture, sample) => sample.stages.some((stage) => stage.history?.passed_mass),
  draw({ sample, state, theme, width }) {
    const { time, passed_mass: mass } = stageOf(sample, state).history;
    if (!mass) return null;
    const { factor, prefix } = prefixOf(1e3 * Math.max(...mass.values, 1e-12), "g");
    const points = Array.from(mass.values, (m, k) => ({ x: time.values[k] - time.values[0], y: (1e3 * m) / factor }));
    return chart(theme, {
      width, height: 236,
      x: { label: "time", unit: "s", ticks: 5 }, y: { label: "mass passed", unit: `${prefix}g` }, tips: { points },
      marks: [Plot.line(points, { x: "x", y: "y", stroke: theme.strong, strokeWidth: 1.7 })],
    });
  },
};
