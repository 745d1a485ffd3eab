import * as Plot from "@observablehq/plot";
import { chart } from "../figures/chart.js";
import { captionOf } from "./caption.js";

/** A number over two swept keys as colour, with its value in every cell. */
export function mapFigure(figure) {
  const cells = figure.series.flatMap(({ name, points }) => points.map(([x, value, error]) => ({ x, row: name, value, error })));
  const values = cells.map(({ value }) => value), low = Math.min(...values), high = Math.max(...values);
  const share = (value) => (high > low ? (value - low) / (high - low) : 0.5);
  return {
    id: figure.id, title: figure.title, caption: captionOf(figure),
    draw: ({ theme, width }) => cells.length > 0 && chart(theme, {
      width, height: 260, marginLeft: 70, gridTicks: [],
      x: { type: "band", label: figure.x.label, domain: [...new Set(cells.map(({ x }) => x))].sort((a, b) => a - b), tickFormat: (v) => `${Number(v.toPrecision(3))}`, padding: 0.04 },
      y: { type: "band", label: null, domain: figure.series.map(({ name }) => name).reverse(), padding: 0.04 },
      marks: [
        Plot.cell(cells, { x: "x", y: "row", fill: ({ value }) => theme.size(share(value)) }),
        Plot.text(cells, { x: "x", y: "row", text: ({ value }) => `${Number(value.toPrecision(3))}`, fill: ({ value }) => inkOn(theme, share(value)), fontSize: 11 }),
      ],
      color: { type: "identity" },
    }),
  };
}

/** Viridis is bright where the scale of light pages starts and where that of dark ones ends. */
const inkOn = (theme, share) => ((theme.name === "dark" ? share > 0.45 : share < 0.55) ? "#14191f" : "#ffffff");
