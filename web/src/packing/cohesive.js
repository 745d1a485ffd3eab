import { s } from "../dom.js";

const into = 0.35; // of the smaller radius: how far a stroke reaches into either grain

/** Pairs that adhesion or a liquid bridge joins: a stroke across the contact or the gap, in the colour of tension where
    the grains are apart; none across a periodic side. */
export function cohesiveShapes(sample, snapshot, camera, theme) {
  const { i, j, gap } = snapshot.cohesive;
  const box = sample.box(snapshot);
  const wide = (box.right - box.left) / 2,
    high = (box.top - box.bottom) / 2;
  const touching = [],
    apart = [];
  for (let p = 0; p < i.length; ++p) {
    const ax = snapshot.x[i[p]],
      ay = snapshot.y[i[p]],
      dx = snapshot.x[j[p]] - ax,
      dy = snapshot.y[j[p]] - ay;
    if (Math.abs(dx) > wide || Math.abs(dy) > high) continue;
    const ri = sample.radius[i[p]],
      rj = sample.radius[j[p]],
      length = Math.hypot(dx, dy),
      reach = into * Math.min(ri, rj);
    const from = (ri - reach) / length,
      to = 1 - (rj - reach) / length;
    const [x1, y1] = camera.toScreen(ax + from * dx, ay + from * dy),
      [x2, y2] = camera.toScreen(ax + to * dx, ay + to * dy);
    (gap[p] > 0 ? apart : touching).push(`M${x1.toFixed(1)} ${y1.toFixed(1)}L${x2.toFixed(1)} ${y2.toFixed(1)}`);
  }
  const path = (lines, stroke, width, name) =>
    s("path", {
      d: lines.join(""),
      fill: "none",
      stroke,
      "stroke-width": width,
      "stroke-linecap": "round",
      class: name,
    });
  return [
    path(touching, theme.materialLine[0], 1.2, "cohesive touching"),
    path(apart, theme.tension, 1.6, "cohesive apart"),
  ].filter((shape) => shape.getAttribute("d"));
}
