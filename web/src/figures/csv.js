import { plain } from "../dom.js";

/** A word as a cell of a table of values parted by commas. */
export const quoted = (word) => (/[",\n]/.test(word) ? `"${word.replaceAll('"', '""')}"` : word);

function written(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "";
  return typeof value === "string" ? quoted(plain(value)) : String(value);
}

/** The points behind a drawing of charts (`numbers` of chart.js). */
export function rowsOf(svg) {
  return (svg?.numbers ?? []).flatMap(({ points }) => points);
}

/** Every point of a drawing as a line of a table: which line it is of, x, y, and the standard error of y where there is
    one, and what else a point has (`more`); a table a chart. */
export function csvOf(svg) {
  const tables = (svg.numbers ?? []).map(({ x, y, points }) => {
    const columns = [
      points.some(({ name }) => name) && ["of", (p) => p.name],
      [x, (p) => p.x],
      [y, (p) => p.y],
      points.some(({ error }) => error > 0) && ["standard error", (p) => p.error],
      ...Object.keys(points[0]?.more ?? {}).map((head) => [head, (p) => p.more[head]]),
    ].filter(Boolean);
    return [columns.map(([head]) => written(head)), ...points.map((p) => columns.map(([, of]) => written(of(p))))]
      .map((row) => row.join(","))
      .join("\n");
  });
  return `${tables.join("\n\n")}\n`;
}
