import { s } from "../dom.js";
import { along, axes, dot, frameOf } from "../space/frame.js";
import { text } from "../text.js";

const steps = 4, // corners along each side of a sector
  tip = 1.16; // of an axis over the radius
const upright = 1,
  rounding = 1e-9;

/** The direction that a point of the projection shows, at a radius (1 on the rim) and an angle counter-clockwise from
    the right: the projection keeps areas and looks down, x to the right and z below. */
export function directionAt(radius, degrees) {
  const angle = (degrees * Math.PI) / 180,
    level = radius * Math.sqrt(Math.max(0, 2 - radius * radius));
  return [level * Math.cos(angle), 1 - radius * radius, -level * Math.sin(angle)];
}

/** The sphere of directions without a sense, in sectors of equal areas, as it is seen from an azimuth and an elevation:
    every sector is there twice, and seen where it is towards the viewer. */
export function turnedSphere(one, { inner, outer, from, to, reach, measure }, [azimuth, elevation], radius, theme) {
  const frame = frameOf(azimuth, elevation, upright);
  const at = (n) => along(frame, n).map((v, k) => (k ? -radius * v : radius * v));
  const sectors = Array.from(one.values, (value, k) => {
    const rim = rimOf(inner[k], outer[k], from[k], to[k]);
    return [1, -1]
      .map((sense) => rim.map((n) => n.map((v) => sense * v)))
      .filter((points) => points.some((n) => dot(frame.towards, n) > rounding))
      .map((points) =>
        s(
          "path",
          {
            d: `M${points.map((n) => at(onFront(frame, n)).map((v) => v.toFixed(2))).join("L")}Z`,
            fill: theme.size(value / reach),
            stroke: theme.size(value / reach),
            "stroke-width": 0.5,
          },
          s("title", {}, `${text.number(value, 3)} ${measure}`),
        ),
      );
  });
  const ends = axes.map((name, axis) => ({ name, n: axes.map((_, k) => Number(k === axis)) }));
  const isSeen = ({ n }) => dot(frame.towards, n) >= 0;
  return [
    ...ends.filter((end) => !isSeen(end)).flatMap((end) => axisOf(end, at, theme, 0.5)),
    ...sectors.flat(),
    s("circle", { r: radius, fill: "none", stroke: theme.rule }),
    ...ends.filter(isSeen).flatMap((end) => axisOf(end, at, theme, 1)),
    ...cross(one.mark, frame, at, theme),
  ];
}

/** Points around a sector. */
function rimOf(inner, outer, from, to) {
  const share = Array.from({ length: steps }, (_, k) => k / steps);
  return [
    ...share.map((t) => directionAt(outer, from + t * (to - from))),
    ...share.map((t) => directionAt(outer + t * (inner - outer), to)),
    ...share.map((t) => directionAt(inner, to + t * (from - to))),
    ...share.map((t) => directionAt(inner + t * (outer - inner), from)),
  ];
}

/** What lies behind ends at the rim. */
function onFront(frame, n) {
  const ahead = dot(frame.towards, n);
  if (ahead >= 0) return n;
  const beside = n.map((v, k) => v - ahead * frame.towards[k]),
    long = Math.hypot(...beside) || 1;
  return beside.map((v) => v / long);
}

function axisOf({ name, n }, at, theme, opacity) {
  const [[x1, y1], [x2, y2], [x, y]] = [1, tip, tip + 0.1].map((far) => at(n.map((v) => far * v)));
  return [
    s("line", { x1, y1, x2, y2, stroke: theme.ink, "stroke-opacity": opacity }),
    s(
      "text",
      {
        x,
        y,
        dy: "0.35em",
        "text-anchor": "middle",
        "font-style": "italic",
        fill: theme.ink,
        opacity,
        stroke: theme.card,
        "stroke-width": 3,
        "paint-order": "stroke",
      },
      name,
    ),
  ];
}

/** The direction of most where it is seen. */
function cross(mark, frame, at, theme) {
  if (!mark) return [];
  const n = directionAt(Math.hypot(...mark), (Math.atan2(mark[1], mark[0]) * 180) / Math.PI),
    sense = dot(frame.towards, n) < 0 ? -1 : 1,
    [x, y] = at(n.map((v) => sense * v));
  return ["M-5,0H5", "M0,-5V5"].map((d) =>
    s("path", { d, stroke: theme.accent, "stroke-width": 2, transform: `translate(${x} ${y})` }),
  );
}
