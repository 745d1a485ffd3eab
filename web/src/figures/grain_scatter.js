import * as Plot from "@observablehq/plot";
import { aboutQuantity, knownQuantities, topOf, valuesOf } from "../quantities.js";
import { isPresent } from "../sample.js";
import { prefixOf } from "../text.js";
import { materialColour, materialLine } from "../theme.js";
import { chart } from "./chart.js";
import { withUnit } from "./tips.js";

const most = 6000; // points that a drawing holds; of more grains every k-th is shown

function axisOf(name, sample) {
  const { symbol, unit: si } = aboutQuantity(name, sample),
    { factor, unit } = prefixOf(topOf(name, sample), si);
  return { factor, axis: { label: symbol, unit } };
}

/** The grains that are drawn, and always the one that is selected. */
function shownGrains(sample, selected) {
  const step = Math.ceil(sample.count / most),
    shown = Array.from({ length: Math.ceil(sample.count / step) }, (_, k) => k * step);
  return selected === null || selected % step === 0 ? shown : [...shown, selected];
}

export const grainScatter = {
  follows: ["snapshot", "across", "up", "selected"],
  when: (texture, sample) => sample.count > 1,
  pickers: { across: ["x", knownOf], up: ["y", knownOf] },
  draw({ sample, state, theme, width }) {
    const snapshot = sample.snapshot(state.get("snapshot")),
      selected = state.get("selected");
    const [x, y] = ["across", "up"].map((key) => axisOf(state.get(key), sample)),
      [across, up] = ["across", "up"].map((key) => valuesOf(state.get(key), sample, snapshot));
    const points = shownGrains(sample, selected)
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
      x: { ...x.axis, nice: true, ticks: 5 },
      y: { ...y.axis, nice: true },
      tips: {
        points,
        by: "both",
        lines: [
          ["", ({ name }) => name],
          [x.axis.label, (p) => withUnit(p.x, x.axis.unit)],
          [y.axis.label, (p) => withUnit(p.y, y.axis.unit)],
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

function knownOf(sample) {
  return knownQuantities(sample).map(([name, { label }]) => [name, label]);
}
