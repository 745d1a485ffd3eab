import { richSvg, s } from "../dom.js";
import { text } from "../text.js";
import { circlesInRows, direction, nameOfCircle, wordsOfCircle } from "./circles.js";
import { turnedSphere } from "./turned_sphere.js";

const head = 36,
  foot = 80;

/** Halves of the sphere of directions side by side, with one scale of colours; with `look` (azimuth and elevation) the
    sphere as it is seen from there. */
export function drawHemispheres(described, { theme, width, look = null }) {
  const { sets, measure } = described,
    perRow = Math.min(sets.length, width >= 560 ? 3 : width >= 380 ? 2 : 1);
  const radius = Math.min((0.5 * width) / perRow - 26, 120),
    height = 2 * radius + head + foot;
  const svg = circlesInRows(sets, { theme, width, perRow, height, middle: head + radius, below: 46 }, (one) => [
    ...(look ? turnedSphere(one, described, look, radius, theme) : hemisphere(one, described, radius, theme)),
    nameOfCircle(one, -radius - 14, theme),
    ...wordsOfCircle(one, radius + 34),
  ]);
  svg.append(...scale(described, width, Math.ceil(sets.length / perRow) * height, theme));
  svg.numbers = [
    {
      x: "part of the half sphere",
      y: measure,
      points: sets.flatMap(({ name, values }) => Array.from(values, (y, k) => ({ name, x: k, y }))),
    },
  ];
  return richSvg(svg);
}

function hemisphere(one, { inner, outer, from, to, reach, measure }, radius, theme) {
  const sectors = Array.from(one.values, (value, k) =>
    s(
      "path",
      { d: sector(inner[k] * radius, outer[k] * radius, from[k], to[k]), fill: theme.size(value / reach) },
      s("title", {}, `${text.number(value, 3)} ${measure}`),
    ),
  );
  return [
    ...sectors,
    s("circle", { r: radius, fill: "none", stroke: theme.rule }),
    ...cross(one.mark, radius, theme),
    s("text", { x: radius + 10, y: 4, "text-anchor": "middle" }, "x"),
    s("text", { y: radius + 14, "text-anchor": "middle" }, "z"),
  ];
}

function sector(inner, outer, from, to) {
  const at = (degrees, r) =>
    direction(degrees, r)
      .map((v) => v.toFixed(2))
      .join(",");
  const arc = (r, end, sense) => `A${r.toFixed(2)},${r.toFixed(2)} 0 0 ${sense} ${at(end, r)}`;
  return `M${at(from, inner)}L${at(from, outer)}${arc(outer, to, 0)}L${at(to, inner)}${arc(inner, from, 1)}Z`;
}

function cross(mark, radius, theme) {
  if (!mark) return [];
  const place = `translate(${mark[0] * radius} ${-mark[1] * radius})`;
  return ["M-5,0H5", "M0,-5V5"].map((d) => s("path", { d, stroke: theme.accent, "stroke-width": 2, transform: place }));
}

/** Colours from 0 to the largest value, with 1, that of no preferred direction, marked. */
function scale({ reach, measure }, width, y, theme) {
  const parts = 40,
    whole = Math.min(180, width - 60),
    left = 0.5 * (width - whole);
  const bars = Array.from({ length: parts }, (_, k) =>
    s("rect", {
      x: left + (k * whole) / parts,
      y,
      width: whole / parts + 0.5,
      height: 8,
      fill: theme.size((k + 0.5) / parts),
    }),
  );
  const ticks = [0, 1, reach].filter((value) => value === reach || value <= 0.85 * reach);
  return [
    ...bars,
    ...ticks.map((value) =>
      s(
        "text",
        { x: left + (value / reach) * whole, y: y + 22, "text-anchor": "middle" },
        `${Number(value.toPrecision(3))}`,
      ),
    ),
    s("text", { x: 0.5 * width, y: y + 38, "text-anchor": "middle" }, measure),
  ];
}
