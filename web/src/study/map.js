import * as Plot from "@observablehq/plot";
import { chart } from "../figures/chart.js";
import { withUnit } from "../figures/tips.js";
import { captionOf } from "./caption.js";

const margin = 70,
  largest = 11,
  widthOfDigit = 0.62; // px, px, of the size of the type

const short = (value) => `${Number(value.toPrecision(3))}`;

/** A number over two swept keys as colour, with its value in every cell. */
export function mapFigure(figure) {
  const cells = figure.series.flatMap(({ name, points }) =>
    points.map(([x, value, error]) => ({ x, row: name, value, error })),
  );
  const values = cells.map(({ value }) => value),
    low = Math.min(...values),
    high = Math.max(...values);
  const share = (value) => (high > low ? (value - low) / (high - low) : 0.5);
  return {
    id: figure.id,
    title: figure.title,
    caption: captionOf(figure),
    draw: ({ theme, width }) =>
      cells.length > 0 &&
      chart(theme, {
        width,
        height: 260,
        marginLeft: margin,
        gridTicks: [],
        x: {
          type: "band",
          label: figure.x.label,
          domain: [...new Set(cells.map(({ x }) => x))].sort((a, b) => a - b),
          tickFormat: short,
          padding: 0.04,
        },
        y: { type: "band", label: null, domain: figure.series.map(({ name }) => name).reverse(), padding: 0.04 },
        marks: [
          Plot.cell(cells, { x: "x", y: "row", fill: ({ value }) => theme.size(share(value)) }),
          Plot.text(cells, {
            x: "x",
            y: "row",
            text: ({ value }) => short(value),
            fill: ({ value }) => inkOn(theme, share(value)),
            fontSize: sizeFor(cells, width),
          }),
        ],
        color: { type: "identity" },
        tips: {
          by: "both",
          reach: 200,
          points: cells.map(({ x, row, value, error }) => ({ x, y: row, value, error })),
          lines: [
            [figure.x.label, ({ x }) => short(x)],
            ["", ({ y }) => y],
            ["", ({ value, error }) => withUnit(value, "", error)],
          ],
        },
      }),
  };
}

/** Type that the longest value fits its cell with. */
function sizeFor(cells, width) {
  const columns = new Set(cells.map(({ x }) => x)).size,
    digits = Math.max(...cells.map(({ value }) => short(value).length));
  return Math.min(largest, (width - margin - 14) / columns / ((digits + 0.8) * widthOfDigit));
}

/** Viridis is bright where the scale of light pages starts and where that of dark ones ends. */
const inkOn = (theme, share) => ((theme.name === "dark" ? share > 0.45 : share < 0.55) ? "#14191f" : "#ffffff");
