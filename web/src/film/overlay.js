import { s } from "../dom.js";
import { drawn, widthOfForce } from "../drawn.js";
import { materialLine } from "../theme.js";

const bright = 0.4; // pixels of the film, around bars

export function stressColour(theme, value) {
  if (!Number.isFinite(value)) return theme.field.aside;
  return theme.stress(Math.min(1, Math.max(0, value / drawn().most_stress.grains)));
}

/** Width of a contact's bar in pixels of the film. */
export const barWidth = (film, fn) => widthOfForce(fn, film.meanForce, film.meanRadius);

/** What lies over the map, in the film's own pixels (column, row): container, grains, forces, motion. Lines that are no
    measure keep their width on the screen. */
export function overlay(film, state, theme) {
  const group = s("g", { fill: "none" });
  if (state.get("grains") !== "off") group.append(container(film, theme), grains(film, state.get("grains"), theme));
  if (state.get("forces") && film.hasForces) group.append(forces(film, theme));
  if (state.get("motion") && film.grains.motion_x) group.append(motion(film, theme));
  return group;
}

const thin = { "vector-effect": "non-scaling-stroke" };
const at = (v) => Number(v).toFixed(3);

function container({ container: sides }, theme) {
  if (!sides) return "";
  const [left, right, bottom, top] = sides;
  return s("rect", {
    x: at(left),
    y: at(top),
    width: at(right - left),
    height: at(bottom - top),
    stroke: theme.wall,
    "stroke-width": 1.25,
    ...thin,
  });
}

/** Rims, all of them on pale lines so that they are seen on any map; or disks filled by their stress. */
function grains(film, how, theme) {
  const { x, y, radius, material } = film.grains,
    group = s("g");
  const circles = (attributes) => {
    for (let g = 0; g < film.count; ++g)
      group.append(s("circle", { cx: at(x[g]), cy: at(y[g]), r: at(radius[g]), ...thin, ...attributes(g) }));
  };
  if (how === "stress")
    circles((g) => ({
      fill: stressColour(theme, film.stresses.film?.sigma_norm[g]),
      stroke: theme.ink,
      "stroke-width": 0.8,
      "stroke-opacity": 0.45,
    }));
  else {
    circles(() => ({ stroke: theme.card, "stroke-width": 3, "stroke-opacity": 0.5 }));
    circles((g) =>
      how === "material"
        ? { stroke: materialLine(theme, material[g]), "stroke-width": 2 }
        : { stroke: theme.strong, "stroke-width": 1.2 },
    );
  }
  return group;
}

/** A bar as thick as its force is large, on a pale one thicker by the standard error, with a margin of the card's
    colour so that it is seen on any map; what may not be there is dashed. */
function forces(film, theme) {
  const { fn, fn_error: error } = film.contacts,
    group = s("g", { "stroke-linecap": "round" });
  const order = Array.from(fn.keys())
    .filter((c) => Number.isFinite(fn[c]))
    .sort((a, b) => Math.abs(fn[a]) - Math.abs(fn[b]));
  const line = (c, attributes) => {
    const [x1, y1, x2, y2] = film.endsOf(c).map(at);
    group.append(s("line", { x1, y1, x2, y2, stroke: fn[c] < 0 ? theme.tension : theme.strong, ...attributes }));
  };
  const thickness = (c) => barWidth(film, Math.abs(fn[c]) + (error?.[c] || 0)),
    sure = order.filter((c) => !film.isUncertain(c));
  for (const c of sure)
    line(c, { stroke: theme.card, "stroke-opacity": 0.45, "stroke-width": at(thickness(c) + bright) });
  for (const c of order.filter((k) => film.isUncertain(k))) {
    line(c, { stroke: theme.card, "stroke-width": 3, "stroke-opacity": 0.5, ...thin });
    line(c, { "stroke-width": 1.3, "stroke-dasharray": "3 4", ...thin });
  }
  for (const c of sure) {
    line(c, { "stroke-width": at(thickness(c)), "stroke-opacity": 0.3 });
    line(c, { "stroke-width": at(barWidth(film, fn[c])) });
  }
  return group;
}

/** How much longer than the true way arrows are drawn: the longest is about a grain. */
export function magnification(film) {
  const longest = film.grains.motion_x.reduce(
    (most, v, g) => Math.max(most, Math.hypot(v, film.grains.motion_y[g])),
    0,
  );
  const wanted = (1.6 * film.meanRadius) / (longest || 1),
    power = 10 ** Math.floor(Math.log10(wanted));
  return [5, 2, 1].map((f) => f * power).find((v) => v <= wanted) ?? power;
}

function motion(film, theme) {
  const { x, y, motion_x: mx, motion_y: my } = film.grains,
    group = s("g", { stroke: theme.accent, fill: theme.accent }),
    k = magnification(film);
  for (let g = 0; g < film.count; ++g) {
    const dx = k * mx[g],
      dy = k * my[g],
      size = Math.hypot(dx, dy);
    if (!(size > 0.15)) continue;
    const [tx, ty] = [x[g] + dx, y[g] + dy],
      head = Math.min(0.5 * size, 0.35 * film.meanRadius),
      ux = dx / size,
      uy = dy / size;
    const wing = (side) => `${at(tx - head * (ux - side * 0.5 * uy))},${at(ty - head * (uy + side * 0.5 * ux))}`;
    group.append(
      s("line", {
        x1: at(x[g]),
        y1: at(y[g]),
        x2: at(tx - 0.8 * head * ux),
        y2: at(ty - 0.8 * head * uy),
        "stroke-width": 1.6,
        ...thin,
      }),
      s("path", { d: `M${at(tx)},${at(ty)}L${wing(1)}L${wing(-1)}Z`, stroke: "none" }),
    );
  }
  return group;
}

/** The outline of what the pointer is on. */
export function outline(film, { grain = null, contact = null, pixel = null }, theme, large) {
  const group = s("g", { fill: "none", stroke: theme.accent });
  if (contact !== null) {
    const [x1, y1, x2, y2] = film.endsOf(contact).map(at);
    group.append(
      s("line", {
        x1,
        y1,
        x2,
        y2,
        "stroke-width": at(Math.max(0.4, barWidth(film, film.contacts.fn[contact]))),
        "stroke-opacity": 0.8,
      }),
    );
  } else if (grain !== null)
    group.append(
      s("circle", {
        cx: at(film.grains.x[grain]),
        cy: at(film.grains.y[grain]),
        r: at(film.grains.radius[grain]),
        "stroke-width": 2.2,
        ...thin,
      }),
    );
  if (pixel !== null && large)
    group.append(
      s("rect", {
        x: (pixel % film.width) - 0.5,
        y: Math.floor(pixel / film.width) - 0.5,
        width: 1,
        height: 1,
        stroke: theme.accent,
        "stroke-width": 1.6,
        ...thin,
      }),
    );
  return group;
}
