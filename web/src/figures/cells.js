import * as Plot from "@observablehq/plot";
import { chart } from "./chart.js";
import { withUnit } from "./tips.js";

const margin = 70,
  largest = 11,
  widthOfDigit = 0.62; // px, px, of the size of the type

const short = (value) => `${Number(value.toPrecision(3))}`.replace("-", "\u2212");

/** A number over two others as colour, with its value in every cell. */
export function drawCells({ x, y, values, error }, { theme, width }) {
  const cells = values
    .map((value, k) => ({
      x: x.names[k % x.names.length],
      y: y.names[Math.floor(k / x.names.length)],
      value,
      error: error[k],
    }))
    .filter(({ value }) => Number.isFinite(value));
  const known = cells.map(({ value }) => value),
    low = Math.min(...known),
    high = Math.max(...known);
  const share = (value) => (high > low ? (value - low) / (high - low) : 0.5);
  return chart(theme, {
    width,
    height: 260,
    marginLeft: margin,
    gridTicks: [],
    x: { type: "band", label: x.label, domain: x.names, padding: 0.04 },
    y: { type: "band", label: null, domain: [...y.names].reverse(), padding: 0.04 },
    marks: [
      Plot.cell(cells, { x: "x", y: "y", fill: ({ value }) => theme.size(share(value)) }),
      Plot.text(cells, {
        x: "x",
        y: "y",
        text: ({ value }) => short(value),
        fill: ({ value }) => inkOn(theme, share(value)),
        fontSize: sizeFor(cells, x.names.length, width),
      }),
    ],
    color: { type: "identity" },
    tips: {
      by: "both",
      reach: 200,
      points: cells,
      lines: [
        [x.label, (cell) => cell.x],
        ["", (cell) => cell.y],
        ["", (cell) => withUnit(cell.value, "", cell.error)],
      ],
    },
  });
}

/** Type that the longest value fits its cell with. */
function sizeFor(cells, columns, width) {
  const digits = Math.max(...cells.map(({ value }) => short(value).length));
  return Math.min(largest, (width - margin - 14) / columns / ((digits + 0.8) * widthOfDigit));
}

/** Viridis is bright where the scale of light pages starts and where that of dark ones ends. */
const inkOn = (theme, share) => ((theme.name === "dark" ? share > 0.45 : share < 0.55) ? "#14191f" : "#ffffff");
