import { s } from "../dom.js";
import { text } from "../text.js";

/** Drawings about a point, side by side or in rows, with room for `below` after the last; draw(one) gives the nodes of
    one about the origin. */
export function circlesInRows(all, { theme, width, perRow, height, middle, below = 0 }, draw) {
  const cell = width / perRow,
    whole = Math.ceil(all.length / perRow) * height + below;
  const svg = s("svg", {
    viewBox: `0 0 ${width} ${whole}`,
    width,
    height: whole,
    "font-family": theme.font,
    "font-size": 11.5,
    fill: theme.soft,
  });
  all.forEach((one, k) => {
    const x = ((k % perRow) + 0.5) * cell,
      y = Math.floor(k / perRow) * height + middle;
    svg.append(s("g", { transform: `translate(${x} ${y})`, "data-set": one.name }, ...draw(one)));
  });
  return svg;
}

/** Name and count of a circle, above it at y. */
export const nameOfCircle = ({ name, count }, y, theme) =>
  s(
    "text",
    { y, "text-anchor": "middle", fill: theme.ink, "font-weight": 600, "font-size": 12 },
    name,
    s("tspan", { fill: theme.soft, "font-weight": 400 }, `  ${text.count(count)}`),
  );

/** Lines of text below a circle, the first at y. */
export const wordsOfCircle = ({ words }, y) =>
  words.map((line, k) => s("text", { y: y + 15 * k, "text-anchor": "middle" }, line));

/** The point at an angle and a radius in an SVG, whose y points down. */
export function direction(degrees, r) {
  const angle = (degrees * Math.PI) / 180;
  return [r * Math.cos(angle), -r * Math.sin(angle)];
}
