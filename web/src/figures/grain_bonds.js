import * as Plot from "@observablehq/plot";
import { chart } from "./chart.js";

const kinds = ["tension", "bending", "shear"];
const opposite = { left: "right", right: "left", bottom: "top", top: "bottom" };
const inward = { left: 1, right: -1, bottom: 1, top: -1 };

const stageOf = (sample, state) => sample.stages[sample.about.snapshots[state.get("snapshot")].stage];
const brokenIn = (stage, kind) => stage.history[`broken_in_${kind}`];
const hasBroken = (stage) => kinds.some((kind) => brokenIn(stage, kind)?.some((count) => count > 0));
const colours = (theme) => [theme.tension, theme.mixedLine[0], theme.strong];

/** Strain by the wall that moves farthest, in percent, shortening positive; the time where none moves. */
function axisOf(stage) {
  const positions = Object.keys(inward).map((side) => ({ side, at: stage.history[`${side}_position`] }));
  const way = ({ at }) => Math.abs(at[at.length - 1] - at[0]);
  const { side, at } = positions.reduce((most, one) => (way(one) > way(most) ? one : most));
  if (!(way({ at }) > 1e-9)) {
    const { time } = stage.history;
    return { label: "time", unit: time.unit, values: Array.from(time, (t) => t - time[0]) };
  }
  const length = Math.abs(at[0] - stage.history[`${opposite[side]}_position`][0]);
  return {
    label: `strain from the ${side} wall`,
    short: "strain",
    unit: "%",
    values: Array.from(at, (x) => (100 * inward[side] * (x - at[0])) / length),
  };
}

/** Bonds between grains that broke, by what broke them. */
export const grainBonds = {
  id: "grain-bonds",
  title: "Broken bonds",
  wide: true,
  follows: true,
  caption:
    "Broken bonds between grains, by failure mode, against the strain of the stage shown. In the picture each is drawn as a crack between its grains.",
  when: (texture, sample) => sample.stages.some(hasBroken),
  key: ({ theme }) => kinds.map((name, k) => ({ name, colour: colours(theme)[k], values: [] })),
  draw({ sample, state, theme, width }) {
    const stage = stageOf(sample, state);
    if (!hasBroken(stage)) return null;
    const { values, ...x } = axisOf(stage);
    const lines = kinds.map((name) => ({
      name,
      rows: Array.from(brokenIn(stage, name), (y, k) => ({ x: values[k], y })),
    }));
    return chart(theme, {
      width,
      height: 254,
      x: { ...x, ticks: 5 },
      y: { label: "broken bonds" },
      tips: { points: lines.flatMap(({ name, rows }) => rows.map((r) => ({ ...r, name }))) },
      marks: lines.map(({ rows }, k) =>
        Plot.line(rows, { x: "x", y: "y", stroke: colours(theme)[k], strokeWidth: 1.6 }),
      ),
    });
  },
};
