import { s } from "../dom.js";
import { drawn, kindWords } from "../drawn.js";
import { bytes } from "../theme.js";
import { stressKey } from "./sample.js";

/** One sample on its nodes: its phases, its broken bonds, or the stress in and about one grain over the mean. */
export function fieldFigure(figure) {
  const { sample } = figure,
    [columns, rows] = sample.nodes;
  return {
    id: figure.id,
    title: figure.title,
    key: ({ theme }) => (sample.stress ? stressKey(theme, drawn().most_stress.nodes) : phaseKey(theme, sample)),
    draw({ theme, width }) {
      const side = Math.min(width, 420),
        scale = side / columns,
        height = Math.ceil(rows * scale);
      const svg = s("svg", { viewBox: `0 0 ${width} ${height}`, width, height });
      const group = s("g", { transform: `translate(${(width - side) / 2} 0)` });
      const colours = sample.stress ? stressColours(theme, sample) : phaseColours(theme, sample);
      group.append(
        s("image", {
          href: painted(columns, rows, colours),
          width: side,
          height,
          preserveAspectRatio: "none",
          style: "image-rendering: pixelated",
        }),
      );
      if (sample.cracks) group.append(...dots(sample.cracks, scale, theme));
      if (sample.edges)
        group.append(
          s("path", { d: outline(sample.edges, scale), fill: "none", stroke: theme.field.outline, "stroke-width": 1 }),
        );
      svg.append(group);
      return svg;
    },
  };
}

function phaseKey(theme, sample) {
  const seen = new Set(sample.phases.filter((_, k) => k % 2 === 0));
  const kinds = drawn()
    .kinds.map((_, kind) => ({ name: kindWords(kind, true), colour: theme.kind[kind] }))
    .filter((_, kind) => seen.has(kind));
  const broken = drawn()
    .cracks.map((name, type) => ({ name: `broken: ${name}`, colour: theme.crack[type] }))
    .filter((_, type) => sample.cracks?.type.includes(type));
  return [...kinds, ...broken];
}

function* phaseColours(theme, { phases: runs }) {
  const colours = theme.kind.map(bytes);
  for (let k = 0; k < runs.length; k += 2) for (let n = 0; n < runs[k + 1]; ++n) yield colours[runs[k]];
}

function* stressColours(theme, { stress }) {
  const most = drawn().most_stress.nodes,
    levels = Array.from({ length: 64 }, (_, k) => bytes(theme.stress(k / 63))),
    empty = bytes(theme.field.empty);
  for (const value of stress)
    yield value === null ? empty : levels[Math.round(63 * Math.min(1, Math.max(0, value / most)))];
}

/** A picture of as many pixels as nodes, as a URL that holds it. */
function painted(columns, rows, colours) {
  const canvas = document.createElement("canvas");
  canvas.width = columns;
  canvas.height = rows;
  const context = canvas.getContext("2d"),
    image = context.createImageData(columns, rows);
  let at = 0;
  for (const [r, g, b] of colours) {
    image.data.set([r, g, b, 255], at);
    at += 4;
  }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

const outline = (edges, scale) =>
  edges
    .map(
      ([x, y, upright]) =>
        `M${(x * scale).toFixed(2)},${(y * scale).toFixed(2)}${upright ? "v" : "h"}${scale.toFixed(2)}`,
    )
    .join("");

/** A dot at every broken bond, one path for each type. */
function dots({ x, y, type }, scale, theme) {
  const paths = drawn().cracks.map(() => []);
  x.forEach((at, k) => paths[type[k]].push(`M${(at * scale).toFixed(1)},${(y[k] * scale).toFixed(1)}h0`));
  const style = { fill: "none", "stroke-linecap": "round", "stroke-width": Math.max(1.4, 0.75 * scale).toFixed(2) };
  return paths
    .map((path, kind) => path.length > 0 && s("path", { d: path.join(""), stroke: theme.crack[kind], ...style }))
    .filter(Boolean);
}
