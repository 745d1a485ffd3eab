import { richSvg, s } from "../dom.js";
import { colourOf, dashOf } from "./colours.js";
import { direction } from "./circles.js";

/** Outlines of numbers by direction with their labelled rings, and a tick for the error of each sector. */
export function drawOutlines({ series, rings, reach, isotropic, corner }, { theme, width }) {
  const height = 270,
    radius = 112,
    scale = radius / reach;
  const group = s("g", { transform: `translate(${width / 2} ${height / 2})`, fill: "none" });
  for (const angle of [0, 45, 90, 135]) {
    const [x, y] = direction(angle, radius);
    group.append(s("line", { x1: -x, y1: -y, x2: x, y2: y, stroke: theme.rule }));
  }
  for (const value of rings) group.append(ring(value * scale, isotropic && value === 1, theme));
  group.append(...angles(radius, theme));
  series.forEach((one, k) => {
    const stroke = colourOf(theme, one.colour),
      d = ticksOfErrors(one, scale, k);
    group.append(
      s("path", { d: outline(one, scale), stroke, "stroke-width": 1.5, "stroke-dasharray": dashOf(one.line) }),
    );
    if (d) group.append(s("path", { class: "scatter", d, stroke, "stroke-width": 1 }));
  });
  group.append(...rings.map((value) => ringLabel(value, scale, theme)));
  if (corner) group.append(s("text", { x: -radius, y: radius, fill: theme.soft, "text-anchor": "middle" }, corner));
  const svg = s(
    "svg",
    { viewBox: `0 0 ${width} ${height}`, width, height, "font-family": theme.font, "font-size": 11 },
    group,
  );
  const points = series.flatMap(pointsOf);
  svg.numbers = [{ x: "direction, \u00b0", y: corner ?? "over the isotropic number", points }];
  return richSvg(svg);
}

const pointsOf = ({ name, x, y, error }) => x.map((at, k) => ({ name, x: at, y: y[k], error: error?.[k] }));

const ring = (r, isIsotropic, theme) =>
  s("circle", {
    r,
    stroke: isIsotropic ? theme.soft : theme.rule,
    "stroke-dasharray": isIsotropic ? "3 3" : null,
  });

function ringLabel(value, scale, theme) {
  const [x, y] = direction(22.5, value * scale),
    halo = { stroke: theme.card, "stroke-width": 3, "paint-order": "stroke" };
  return s("text", { x, y, fill: theme.soft, ...halo, "text-anchor": "middle", dy: "0.35em" }, `${value}`);
}

const angles = (radius, theme) =>
  [
    [0, "start"],
    [90, "middle"],
    [180, "end"],
  ].map(([angle, anchor]) => {
    const [x, y] = direction(angle, radius + 6),
      dy = angle === 90 ? "-0.1em" : "0.35em";
    return s("text", { x, y, fill: theme.soft, "text-anchor": anchor, dy }, `${angle}\u00b0`);
  });

const pathOf = (points) => points.map((p) => p.map((v) => v.toFixed(2)).join(",")).join("L");

function outline({ x, y }, scale) {
  const half = 180 / (2 * x.length);
  const corners = [0, 180].flatMap((turn) =>
    x.flatMap((middle, k) => [-half, half].map((aside) => direction(turn + middle + aside, y[k] * scale))),
  );
  return `M${pathOf(corners)}Z`;
}

/** From y - e to y + e in every sector; series stand a little aside of each other. */
function ticksOfErrors({ x, y, error = [] }, scale, place) {
  const aside = (180 / x.length) * 0.2 * ((place % 4) - 1.5);
  return [0, 180]
    .flatMap((turn) =>
      x.map((middle, k) => {
        if (!(error[k] > 0)) return "";
        const ends = [Math.max(0, y[k] - error[k]), y[k] + error[k]];
        return `M${pathOf(ends.map((r) => direction(turn + middle + aside, r * scale)))}`;
      }),
    )
    .join("");
}
