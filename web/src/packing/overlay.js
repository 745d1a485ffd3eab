import { s } from "../dom.js";
import { text } from "../text.js";
import { bondShapes } from "./bonds.js";
import { chainWidth, segmentsOf } from "./chains.js";
import { cohesiveShapes } from "./cohesive.js";
import { rimOf } from "./shapes.js";

const thick = 5;

/** What lies over the grains as vectors: walls with the forces on them, and the outline of what the pointer is on. */
export function overlay(sample, snapshot, camera, theme, { walls, picked = null, selected = null }) {
  const group = s("g", { "font-family": theme.font, "font-size": 11.5 });
  if (walls && snapshot.bonds) group.append(...bondShapes(sample, snapshot, camera, theme));
  if (walls && snapshot.cohesive) group.append(...cohesiveShapes(sample, snapshot, camera, theme));
  if (walls) group.append(...wallShapes(sample, snapshot, camera, theme), ...boundaryShapes(snapshot, camera, theme));
  if (selected !== null)
    group.append(
      ring(sample, snapshot, camera, selected, theme.card, 5),
      ring(sample, snapshot, camera, selected, theme.accent, 3, "selected"),
    );
  if (picked) group.append(...outline(sample, snapshot, camera, theme, picked));
  return group;
}

function wallShapes(sample, snapshot, camera, theme) {
  const box = sample.box(snapshot);
  const [left, top] = camera.toScreen(box.left, box.top);
  const [right, bottom] = camera.toScreen(box.right, box.bottom);
  const middleX = (left + right) / 2,
    middleY = (top + bottom) / 2;
  const places = [
    { rect: [left - thick, top - thick, thick, bottom - top + 2 * thick], at: [left - thick - 9, middleY], turn: -90 },
    { rect: [right, top - thick, thick, bottom - top + 2 * thick], at: [right + thick + 9, middleY], turn: 90 },
    { rect: [left - thick, bottom, right - left + 2 * thick, thick], at: [middleX, bottom + thick + 9], turn: 0 },
    { rect: [left - thick, top - thick, right - left + 2 * thick, thick], at: [middleX, top - thick - 9], turn: 0 },
  ];
  const loaded = snapshot.domain.walls.some((wall) => wall.force !== 0);
  return snapshot.domain.walls.flatMap((wall, side) => {
    const {
      rect: [x, y, width, height],
      at,
      turn,
    } = places[side];
    if (!wall.present) {
      return [
        s("rect", {
          x,
          y,
          width,
          height,
          fill: "none",
          stroke: theme.wall,
          "stroke-dasharray": "4 4",
          "stroke-width": 1,
        }),
      ];
    }
    return [
      s("rect", { x, y, width, height, rx: 1.5, fill: theme.wall, class: "wall" }),
      loaded &&
        s(
          "text",
          {
            x: at[0],
            y: at[1],
            dy: "0.35em",
            "text-anchor": "middle",
            fill: theme.soft,
            transform: turn ? `rotate(${turn} ${at[0]} ${at[1]})` : null,
          },
          text.quantity(wall.force, "N"),
        ),
    ].filter(Boolean);
  });
}

/** Boundaries and membranes beside the walls; a dashed line where one is absent. */
export function boundaryShapes(snapshot, camera, theme) {
  return (snapshot.boundaries ?? []).map(({ x, y, closed, present }) =>
    s(closed ? "polygon" : "polyline", {
      points: Array.from(x, (_, p) => camera.toScreen(x[p], y[p]).join(",")).join(" "),
      fill: "none",
      stroke: theme.wall,
      "stroke-width": present ? 2.5 : 1,
      "stroke-dasharray": present ? null : "4 4",
      "stroke-linejoin": "round",
      "stroke-linecap": "round",
      class: "boundary",
    }),
  );
}

function ring(sample, snapshot, camera, grain, stroke, width, name = null) {
  const [cx, cy] = camera.toScreen(snapshot.x[grain], snapshot.y[grain]);
  return s("circle", {
    cx,
    cy,
    r: sample.radius[grain] * camera.scale + 1,
    fill: "none",
    stroke,
    "stroke-width": width,
    class: name,
  });
}

function outline(sample, snapshot, camera, theme, { grain, contact }) {
  if (grain !== undefined && sample.shapes) {
    const points = rimOf(sample, snapshot, grain)
      .map(([x, y]) => camera.toScreen(x, y).join(","))
      .join(" ");
    return [s("polygon", { points, fill: "none", stroke: theme.ink, "stroke-width": 2 })];
  }
  if (grain !== undefined) {
    return [ring(sample, snapshot, camera, grain, theme.ink, 2)];
  }
  const width = Math.max(3, chainWidth(sample, snapshot, snapshot.contacts.fn[contact]) * camera.scale) + 3;
  return segmentsOf(sample, snapshot, contact).map(([ax, ay, bx, by]) => {
    const [x1, y1] = camera.toScreen(ax, ay),
      [x2, y2] = camera.toScreen(bx, by);
    return s("line", {
      x1,
      y1,
      x2,
      y2,
      stroke: theme.accent,
      "stroke-width": width,
      "stroke-linecap": "round",
      opacity: 0.75,
    });
  });
}
