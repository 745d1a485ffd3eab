import * as Plot from "@observablehq/plot";
import { chart } from "./chart.js";

const rows = ({ diameter, passing }) => Array.from(diameter, (d, k) => ({ x: 1e3 * d, y: 100 * passing[k] }));

export const sizeCurve = {
  id: "size-curve",
  title: "Size curve",
  follows: ["selected"],
  caption:
    "Fraction of the mass in grains no wider than the given diameter, for the grains drawn and for the size laws of the recipe.",
  when: (texture, sample) => sample.sizes,
  key: ({ theme }) => [
    { name: "measured", colour: theme.strong, values: [] },
    { name: "asked", colour: theme.accent, dash: "6 3", values: [] },
  ],
  draw({ sample, state, theme, width }) {
    const lines = [
      ["measured", theme.strong, null],
      ["asked", theme.accent, "6 3"],
    ].map(([name, colour, dash]) => ({ name, colour, dash, rows: rows(sample.sizes[name]) }));
    const all = lines.flatMap((line) => line.rows.map(({ x }) => x)),
      low = Math.min(...all),
      high = Math.max(...all),
      chosen = state.get("selected");
    return chart(theme, {
      width,
      height: 254,
      x: {
        type: low > 0 && high / low > 20 ? "log" : "linear",
        label: "diameter",
        unit: "mm",
        ticks: 5,
        domain: high > low ? [low, high] : [0.9 * low, 1.1 * low],
      },
      y: { label: "mass passing", short: "passing", unit: "%", domain: [0, 100] },
      tips: { points: lines.flatMap((line) => line.rows.map((r) => ({ ...r, name: line.name }))), reach: 200 },
      marks: [
        chosen === null
          ? null
          : Plot.ruleX([2e3 * sample.radius[chosen]], { stroke: theme.accent, strokeWidth: 2, className: "selected" }),
        ...lines.map((line) =>
          Plot.line(line.rows, {
            x: "x",
            y: "y",
            stroke: line.colour,
            strokeDasharray: line.dash,
            strokeWidth: 1.7,
            curve: "step-after",
          }),
        ),
      ],
    });
  },
};
