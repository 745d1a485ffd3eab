import { s } from "./dom.js";
import { text } from "./text.js";

/** A bar of round length at the right end of a strip. */
export function scaleBar(camera, theme, width, write = (length) => text.quantity(length, "m", 1)) {
  const wanted = 110 / camera.scale;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const length = [5, 2, 1].map((f) => f * power).find((l) => l <= wanted) ?? power;
  const pixels = length * camera.scale;
  const right = width - 2;
  return s(
    "g",
    {},
    s("path", { d: `M${right - pixels},10 v6 h${pixels} v-6`, fill: "none", stroke: theme.ink, "stroke-width": 1.25 }),
    s("text", { x: right - pixels / 2, y: 27, dy: "0.35em", "text-anchor": "middle" }, write(length)),
  );
}
