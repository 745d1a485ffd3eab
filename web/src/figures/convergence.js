import * as Plot from "@observablehq/plot";
import { chart, decadesAround, logAxis } from "./chart.js";

export const convergence = {
  id: "convergence",
  title: "Convergence of the solver",
  caption: "Residual relative to that of uniform strain, after every iteration.",
  when: (_, result) => (result.convergence.residual?.length ?? 0) > 1,
  draw({ sample, theme, width }) {
    const { residual, iteration } = sample.convergence;
    const rows = Array.from(residual, (y, k) => ({ x: iteration?.[k] ?? k, y })).filter(({ y }) => y > 0);
    const values = rows.map(({ y }) => y);
    const domain = decadesAround(Math.min(...values), Math.max(...values));
    return chart(theme, {
      width,
      height: 254,
      x: { label: "iteration", ticks: 6, tickFormat: (v) => (Number.isInteger(v) ? String(v) : "") },
      y: logAxis("residual", domain),
      tips: { points: rows },
      marks: [
        Plot.line(rows, { x: "x", y: "y", stroke: theme.materialLine[0], strokeWidth: 1.6 }),
        rows.length < 200 ? Plot.dot(rows, { x: "x", y: "y", fill: theme.materialLine[0], r: 2.6 }) : null,
      ],
    });
  },
};
