import { richSvg, s } from "../dom.js";
import { direction } from "../figures/roses.js";
import { captionOf } from "./caption.js";

/** Outlines of the numbers of contacts in sectors, or of their shares over the isotropic one, which is the dashed circle; with a
    tick for the scatter of each sector. Half a turn is mirrored. */
export function roseFigure(figure, colours, dash) {
  const { series, counts } = figure;
  return {
    id: figure.id,
    title: figure.title,
    caption: captionOf(figure),
    key: ({ theme }) =>
      series
        .filter(({ name }) => name)
        .map((one, k) => ({ name: one.name, colour: colours(theme, figure)[k], dash: dash(figure, one) })),
    draw({ theme, width }) {
      if (series.length === 0) return null;
      const height = 270,
        radius = 112;
      const largest = Math.max(counts ? 1e-9 : 1.3, ...series.flatMap(({ points }) => points.map(([, y, e]) => y + e)));
      const scale = radius / largest,
        labels = [];
      const group = s("g", { transform: `translate(${width / 2} ${height / 2})`, fill: "none" });
      for (const angle of [0, 45, 90, 135]) {
        const [x, y] = direction(angle, radius);
        group.append(s("line", { x1: -x, y1: -y, x2: x, y2: y, stroke: theme.rule }));
      }
      for (const value of counts ? ticksOfCounts(largest) : ticksOfShares(largest)) {
        const isotropic = !counts && value === 1,
          [x, y] = direction(22.5, value * scale);
        group.append(
          s("circle", {
            r: value * scale,
            stroke: isotropic ? theme.soft : theme.rule,
            "stroke-dasharray": isotropic ? "3 3" : null,
          }),
        );
        labels.push(
          s(
            "text",
            {
              x,
              y,
              fill: theme.soft,
              stroke: theme.card,
              "stroke-width": 3,
              "paint-order": "stroke",
              "text-anchor": "middle",
              dy: "0.35em",
            },
            `${value}`,
          ),
        );
      }
      for (const [angle, label, anchor] of [
        [0, "0\u00b0", "start"],
        [90, "90\u00b0", "middle"],
        [180, "180\u00b0", "end"],
      ]) {
        const [x, y] = direction(angle, radius + 6);
        group.append(
          s("text", { x, y, fill: theme.soft, "text-anchor": anchor, dy: angle === 90 ? "-0.1em" : "0.35em" }, label),
        );
      }
      series.forEach((one, k) => {
        const stroke = colours(theme, figure)[k],
          d = ticksOfScatter(one.points, scale, k);
        group.append(
          s("path", {
            d: outline(one.points, scale),
            stroke,
            "stroke-width": 1.5,
            "stroke-dasharray": dash(figure, one),
          }),
        );
        if (d) group.append(s("path", { class: "scatter", d, stroke, "stroke-width": 1 }));
      });
      group.append(...labels);
      if (counts)
        group.append(s("text", { x: -radius, y: radius, fill: theme.soft, "text-anchor": "middle" }, "N_{c}"));
      return richSvg(
        s(
          "svg",
          { viewBox: `0 0 ${width} ${height}`, width, height, "font-family": theme.font, "font-size": 11 },
          group,
        ),
      );
    },
  };
}

function ticksOfShares(largest) {
  const step = largest > 6 ? 2 : largest > 2.5 ? 1 : 0.5,
    list = [];
  for (let share = step; share <= largest + 1e-9; share += step) list.push(share);
  return list.includes(1) ? list : [1, ...list];
}

/** Two to four round numbers. */
export function ticksOfCounts(largest) {
  const power = 10 ** Math.floor(Math.log10(largest / 2)),
    step = [5, 2, 1].map((digit) => digit * power).find((one) => 2 * one <= largest);
  return Array.from({ length: Math.floor(largest / step + 1e-9) }, (_, k) => Number(((k + 1) * step).toPrecision(6)));
}

function outline(points, scale) {
  const half = 180 / (2 * points.length);
  const corners = [0, 180].flatMap((turn) =>
    points.flatMap(([middle, y]) => [
      direction(turn + middle - half, y * scale),
      direction(turn + middle + half, y * scale),
    ]),
  );
  return `M${corners.map((p) => p.map((v) => v.toFixed(2)).join(",")).join("L")}Z`;
}

/** From y - e to y + e in every sector; curves stand a little aside of each other. */
function ticksOfScatter(points, scale, k) {
  const aside = (180 / points.length) * 0.2 * ((k % 4) - 1.5);
  const at = (angle, r) =>
    direction(angle, r)
      .map((v) => v.toFixed(2))
      .join(",");
  return [0, 180]
    .flatMap((turn) =>
      points
        .filter(([, , e]) => e > 0)
        .map(
          ([middle, y, e]) =>
            `M${at(turn + middle + aside, Math.max(0, y - e) * scale)}L${at(turn + middle + aside, (y + e) * scale)}`,
        ),
    )
    .join("");
}
