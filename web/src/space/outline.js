import { label, s } from "../dom.js";
import { axes } from "./frame.js";

const others = (axis) => axes.map((_, a) => a).filter((a) => a !== axis);

/** The edges of what is left of the sample that are not behind it, each [axis, ends, number of faces towards the
    viewer], from the middle. */
function edges({ towards }, size, kept) {
  const list = [];
  for (const axis of [0, 1, 2]) {
    const [b, c] = others(axis);
    for (const sb of [0, 1])
      for (const sc of [0, 1]) {
        const faces = (sb ? towards[b] : -towards[b]) > 0,
          beside = (sc ? towards[c] : -towards[c]) > 0;
        if (!faces && !beside) continue;
        const end = (along) => {
          const point = [];
          point[axis] = along - size[axis] / 2;
          point[b] = sb * kept[b] - size[b] / 2;
          point[c] = sc * kept[c] - size[c] / 2;
          return point;
        };
        list.push({ axis, ends: [end(0), end(kept[axis])], rim: faces !== beside });
      }
  }
  return list;
}

/** Where the three slices cut the faces that are towards the viewer. */
function cuts({ towards }, size, kept, slices) {
  return [0, 1, 2].flatMap((axis) =>
    slices[axis] >= kept[axis]
      ? []
      : others(axis).map((b) => {
          const [along] = others(axis).filter((a) => a !== b);
          const end = (place) => {
            const point = [];
            point[axis] = slices[axis] + 0.5 - size[axis] / 2;
            point[b] = (towards[b] > 0 ? kept[b] : 0) - size[b] / 2;
            point[along] = place - size[along] / 2;
            return point;
          };
          return { axis, ends: [end(0), end(kept[along])] };
        }),
  );
}

/** Edges, their axes' names, and the lines of the slices, in pixels of the picture; `toScreen` takes a point of space
    from the middle. */
export function outline(frame, size, kept, slices, toScreen, theme, upright = 2) {
  const line = ({ ends, axis }, stroke, more) => {
    const [[x1, y1], [x2, y2]] = ends.map(toScreen);
    return s("line", { x1, y1, x2, y2, stroke, "data-axis": axes[axis], ...more });
  };
  const seen = edges(frame, size, kept);
  return s(
    "g",
    { "font-family": theme.font, "font-size": 13, "font-style": "italic", fill: theme.soft },
    slices &&
      cuts(frame, size, kept, slices).map((cut) =>
        line(cut, theme.ink, {
          class: "slice-line",
          "stroke-width": 1,
          "stroke-opacity": 0.55,
          "stroke-dasharray": "5 4",
        }),
      ),
    seen.map((edge) => line(edge, theme.ink, { "stroke-width": 1, "stroke-opacity": 0.65 })),
    [0, 1, 2].map((axis) => nameOf(axis, seen, toScreen, axis === upright)),
  );
}

/** The name of an axis beside its lowest edge on the rim, that of an upright one beside the edge most to the left. */
function nameOf(axis, seen, toScreen, isUpright) {
  const rims = seen
    .filter((edge) => edge.axis === axis && edge.rim)
    .map(({ ends }) => {
      const [[x1, y1], [x2, y2]] = ends.map(toScreen);
      return { x: (x1 + x2) / 2, y: (y1 + y2) / 2, long: Math.hypot(x2 - x1, y2 - y1) };
    });
  if (!rims.length || rims[0].long < 25) return null;
  const best = rims.reduce((a, b) => ((isUpright ? b.x < a.x : b.y > a.y) ? b : a)),
    [mx, my] = toScreen([0, 0, 0]),
    away = Math.hypot(best.x - mx, best.y - my) || 1;
  return label(best.x + (13 * (best.x - mx)) / away, best.y + (13 * (best.y - my)) / away, axes[axis], "middle");
}
