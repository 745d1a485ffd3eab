import { richSvg, s } from "../dom.js";
import { circlesInRows, direction, nameOfCircle, wordsOfCircle } from "./circles.js";
import { colourOf } from "./colours.js";

/** Polar histograms side by side, or in rows. */
export function drawRoses(roses, { theme, width }) {
  const perRow = Math.min(roses.length, width >= 1000 ? 6 : width >= 380 ? 3 : 2);
  const cell = width / perRow,
    radius = Math.min(0.5 * cell - 18, roses.length < 3 ? 110 : 88),
    height = 2 * radius + 96;
  const svg = circlesInRows(roses, { theme, width, perRow, height, middle: 36 + radius }, (one) => [
    rose(one, radius, theme),
  ]);
  svg.numbers = [
    {
      x: "direction, \u00b0",
      y: "contacts over the isotropic number",
      points: roses.flatMap(({ name, sectors }) =>
        Array.from(sectors, (y, k) => ({ name, x: ((k + 0.5) * 180) / sectors.length, y })),
      ),
    },
  ];
  return richSvg(svg);
}

/** One about the origin. */
function rose(described, radius, theme) {
  const { colour: role, sectors, inner, line, axis, reach } = described;
  const scale = radius / reach,
    colour = colourOf(theme, role);
  const group = s("g");
  group.append(s("circle", { r: radius, fill: "none", stroke: theme.rule }));
  for (const angle of [0, 45, 90, 135]) {
    const [dx, dy] = direction(angle, radius);
    group.append(s("line", { x1: -dx, y1: -dy, x2: dx, y2: dy, stroke: theme.rule }));
  }
  group.append(...petals(sectors, scale, colour, inner ? 0.35 : 0.5));
  if (inner) group.append(...petals(inner, scale, colour, 0.75));
  group.append(s("circle", { r: scale, fill: "none", stroke: theme.soft, "stroke-dasharray": "3 3" }));
  if (line) group.append(s("path", { d: around(line, scale), fill: "none", stroke: theme.ink, "stroke-width": 1.5 }));
  group.append(
    ...axisMarks(axis, radius, theme),
    nameOfCircle(described, -radius - 18, theme),
    ...wordsOfCircle(described, radius + 24),
  );
  return group;
}

function petals(sectors, scale, fill, opacity) {
  return [...sectors, ...sectors].map((fraction, k) => {
    const r = fraction * scale,
      step = 180 / sectors.length;
    const [x1, y1] = direction(k * step + 0.8, r),
      [x2, y2] = direction((k + 1) * step - 0.8, r);
    return s("path", {
      d:
        `M0,0L${x1.toFixed(2)},${y1.toFixed(2)}` +
        `A${r.toFixed(2)},${r.toFixed(2)} 0 0 0 ${x2.toFixed(2)},${y2.toFixed(2)}Z`,
      fill,
      "fill-opacity": opacity,
    });
  });
}

/** A line of these radii by equal angles over half a turn, and mirrored. */
function around(radii, scale) {
  const places = [...radii, ...radii].map((r, k) => direction((180 * k) / radii.length, r * scale));
  return `M${places.map((place) => place.map((v) => v.toFixed(2)).join(",")).join("L")}Z`;
}

function axisMarks(degrees, radius, theme) {
  if (degrees === undefined) return [];
  return [degrees, degrees + 180].map((angle) => {
    const [x, y] = direction(angle, radius + 6);
    return s("path", {
      d: "M-5,0 L3,-3.6 L3,3.6Z",
      fill: theme.accent,
      transform: `translate(${x} ${y}) rotate(${-angle})`,
    });
  });
}
