import * as Plot from "@observablehq/plot";
import { isKnown, valuesOf } from "../quantities.js";
import { isPresent } from "../sample.js";
import { materialColour, materialLine } from "../theme.js";
import { chart } from "./chart.js";
import { withUnit } from "./tips.js";

const id = "grain-scatter";

/** What the program describes of it: { axes: [{ quantity, words, label, unit, factor }], across, up, every }; undefined
    where there is nothing to draw. */
export const scatterOf = (sample) => sample.ofRun(id)?.[0].scatter;

/** The numbers that the page has of each of its grains: [[quantity, words]]. */
export const known = (sample) =>
  (scatterOf(sample)?.axes ?? [])
    .filter(({ quantity }) => sample.finders[quantity] && isKnown(quantity, sample))
    .map(({ quantity, words }) => [quantity, words]);

/** What it shows at first, as print does. */
export function begins(sample) {
  const { across = "", up = "" } = scatterOf(sample) ?? {};
  return { across, up };
}

/** The grains that are drawn, and always the one that is selected. */
function shownGrains({ count }, every, selected) {
  const shown = Array.from({ length: Math.ceil(count / every) }, (_, k) => k * every);
  return selected === null || selected % every === 0 ? shown : [...shown, selected];
}

export const grainScatter = {
  follows: ["snapshot", "across", "up", "selected"],
  when: (texture, sample) => sample.hasDrawn(id),
  pickers: { across: ["x", known], up: ["y", known] },
  draw({ sample, state, theme, width }) {
    const snapshot = sample.snapshot(state.get("snapshot")),
      selected = state.get("selected"),
      { axes, every } = scatterOf(sample);
    const [x, y] = ["across", "up"].map((key) => axes.find(({ quantity }) => quantity === state.get(key))),
      [across, up] = [x, y].map(({ quantity }) => valuesOf(quantity, sample, snapshot));
    const points = shownGrains(sample, every, selected)
      .filter((g) => isPresent(snapshot, g))
      .map((g) => ({
        g,
        x: across[g] / x.factor,
        y: up[g] / y.factor,
        name: `grain ${sample.id[g]}, ${sample.materialName(g)}`,
      }))
      .filter((p) => Number.isFinite(p.x) && Number.isFinite(p.y));
    const chosen = points.filter(({ g }) => g === selected);
    const svg = chart(theme, {
      width,
      height: 254,
      marginLeft: 60,
      x: { label: x.label, unit: x.unit, nice: true, ticks: 5 },
      y: { label: y.label, unit: y.unit, nice: true },
      tips: {
        points,
        by: "both",
        lines: [
          ["", ({ name }) => name],
          [x.label, (p) => withUnit(p.x, x.unit)],
          [y.label, (p) => withUnit(p.y, y.unit)],
        ],
      },
      marks: [
        Plot.dot(points, {
          x: "x",
          y: "y",
          r: 2,
          fill: ({ g }) => materialColour(theme, sample.material[g]),
          fillOpacity: 0.75,
          stroke: ({ g }) => materialLine(theme, sample.material[g]),
          strokeWidth: 0.4,
          strokeOpacity: 0.7,
        }),
        Plot.dot(chosen, { x: "x", y: "y", r: 6, stroke: theme.accent, strokeWidth: 2.4, className: "selected" }),
      ],
    });
    svg.addEventListener("input", () => state.set({ pointed: svg.value?.g ?? null }));
    svg.addEventListener("pointerleave", () => state.set({ pointed: null }));
    svg.addEventListener(
      "click",
      () => svg.value && state.set({ selected: svg.value.g === selected ? null : svg.value.g }),
    );
    return svg;
  },
};
