import { richSvg, s } from "../dom.js";
import { text } from "../text.js";
import { direction } from "./roses.js";

const head = 36,
  foot = 80;

/** Halves of the sphere of directions side by side, with one scale of colours. */
export function drawHemispheres(all, { theme, width }) {
  const perRow = Math.min(all.length, width >= 560 ? 3 : width >= 380 ? 2 : 1);
  const cell = width / perRow,
    radius = Math.min(0.5 * cell - 26, 120),
    height = 2 * radius + head + foot,
    rows = Math.ceil(all.length / perRow);
  const svg = s("svg", {
    viewBox: `0 0 ${width} ${rows * height + 34}`,
    width,
    height: rows * height + 34,
    "font-family": theme.font,
    "font-size": 11.5,
    fill: theme.soft,
  });
  all.forEach((one, k) => {
    const x = ((k % perRow) + 0.5) * cell,
      y = Math.floor(k / perRow) * height + head + radius;
    svg.append(s("g", { transform: `translate(${x} ${y})`, "data-set": one.name }, ...hemisphere(one, radius, theme)));
  });
  svg.append(...scale(all[0], width, rows * height, theme));
  svg.numbers = [
    {
      x: "part of the half sphere",
      y: all[0].measure,
      points: all.flatMap(({ name, values }) => Array.from(values, (y, k) => ({ name, x: k, y }))),
    },
  ];
  return richSvg(svg);
}

function hemisphere({ name, count, inner, outer, from, to, values, mark, reach, measure, words }, radius, theme) {
  const sectors = Array.from(values, (value, k) =>
    s(
      "path",
      { d: sector(inner[k] * radius, outer[k] * radius, from[k], to[k]), fill: theme.size(value / reach) },
      s("title", {}, `${text.number(value, 3)} ${measure}`),
    ),
  );
  const label = (x, y, words, rest = {}) => s("text", { x, y, "text-anchor": "middle", ...rest }, words);
  return [
    ...sectors,
    s("circle", { r: radius, fill: "none", stroke: theme.rule }),
    ...cross(mark, radius, theme),
    label(radius + 10, 4, "x"),
    label(0, radius + 14, "z"),
    s(
      "text",
      { y: -radius - 14, "text-anchor": "middle", fill: theme.ink, "font-weight": 600, "font-size": 12 },
      name,
      s("tspan", { fill: theme.soft, "font-weight": 400 }, `  ${text.count(count)}`),
    ),
    ...words.map((line, k) => label(0, radius + 34 + 15 * k, line)),
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
    s("text", { x: left + whole + 14, y: y + 8 }, measure),
  ];
}
