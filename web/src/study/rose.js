import { richSvg, s } from "../dom.js";
import { direction } from "../figures/roses.js";
import { captionOf } from "./caption.js";

/** Outlines of the sectors' shares over the isotropic one, which is the dashed circle; half a turn is mirrored. */
export function roseFigure(figure, colours, dash) {
  const { series } = figure;
  return {
    id: figure.id, title: figure.title, caption: captionOf(figure),
    key: ({ theme }) => series.filter(({ name }) => name).map((one, k) => ({ name: one.name, colour: colours(theme, figure)[k], dash: dash(figure, one), values: [] })),
    draw({ theme, width }) {
      if (series.length === 0) return null;
      const height = 270, radius = 112;
      const largest = Math.max(1.3, ...series.flatMap(({ points }) => points.map(([, y]) => y)));
      const scale = radius / largest;
      const group = s("g", { transform: `translate(${width / 2} ${height / 2})`, fill: "none" });
      for (const angle of [0, 45, 90, 135]) {
        const [x, y] = direction(angle, radius);
        group.append(s("line", { x1: -x, y1: -y, x2: x, y2: y, stroke: theme.rule }));
      }
      for (const share of ticks(largest)) {
        group.append(s("circle", { r: share * scale, stroke: share === 1 ? theme.soft : theme.rule, "stroke-dasharray": share === 1 ? "3 3" : null }));
        const [x, y] = direction(22.5, share * scale);
        group.append(s("text", { x, y, fill: theme.soft, "text-anchor": "middle", dy: "0.35em" }, `${share}`));
      }
      for (const [angle, label, anchor] of [[0, "0\u00b0", "start"], [90, "90\u00b0", "middle"], [180, "180\u00b0", "end"]]) {
        const [x, y] = direction(angle, radius + 6);
        group.append(s("text", { x, y, fill: theme.soft, "text-anchor": anchor, dy: angle === 90 ? "-0.1em" : "0.35em" }, label));
      }
      series.forEach((one, k) => group.append(s("path", { d: outline(one.points, scale), stroke: colours(theme, figure)[k], "stroke-width": 1.5, "stroke-dasharray": dash(figure, one) })));
      return richSvg(s("svg", { viewBox: `0 0 ${width} ${height}`, width, height, "font-family": theme.font, "font-size": 11 }, group));
    },
  };
}

function ticks(largest) {
  const step = largest > 6 ? 2 : largest > 2.5 ? 1 : 0.5, list = [];
  for (let share = step; share <= largest + 1e-9; share += step) list.push(share);
  return list.includes(1) ? list : [1, ...list];
}

function outline(points, scale) {
  const half = 180 / (2 * points.length);
  const corners = [0, 180].flatMap((turn) => points.flatMap(([middle, y]) => [direction(turn + middle - half, y * scale), direction(turn + middle + half, y * scale)]));
  return `M${corners.map((p) => p.map((v) => v.toFixed(2)).join(",")).join("L")}Z`;
}
