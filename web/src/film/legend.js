import { bar, colourBar } from "../colour_bar.js";
import { label, richSvg, s } from "../dom.js";
import { drawn } from "../drawn.js";
import { scaleBar } from "../scale_bar.js";
import { text } from "../text.js";
import { materialLine } from "../theme.js";
import { barWidth, magnification } from "./overlay.js";
import { scaleOf } from "./paint.js";

export const legendHeight = 92;
const narrow = 260; // px, of the colours' bar

/** The strip below the film: what the colours mean, what the lines mean, and a bar of known length. */
export function legend(film, camera, theme, state, width) {
  const group = s("g", { "font-family": theme.font, "font-size": 11.5, fill: theme.soft });
  const length = Math.max(150, Math.min(420, width - 150)),
    how = state.get("grains");
  group.append(
    how === "stress" ? stressKey(theme, Math.min(260, length)) : mapKey(film, state, theme, length),
    lineKey(film, camera, theme, state),
  );
  const { pixel } = film.about.film;
  group.append(pixel > 0 ? scaleBar({ scale: camera.scale / pixel }, theme, width) : "");
  return richSvg(group);
}

function mapKey(film, state, theme, length) {
  const name = state.get("map"),
    { title, colours, cyclic, marks } = film.about.maps[name];
  const key = colourBar({
    title: length < narrow ? title.replace(/ \(.*\)/, "") : title, // beside it there is the bar of known length
    unit: film.unitOf(name),
    scale: scaleOf(film, state),
    palette: theme.scales[colours],
    theme,
    length,
    at: cyclic ? [-180, -90, 0, 90, 180] : null,
  });
  if (!marks) return key;
  const share = text.number((100 * film.bad.length) / (film.width * film.height), 2);
  return s(
    "g",
    {},
    key,
    s("rect", { x: 0, y: 75, width: 11, height: 11, rx: 2, fill: theme.badPixel }),
    label(17, 81, `${text.count(film.bad.length)} replaced, ${share}\u202f%`),
  );
}

export function stressKey(theme, length) {
  const top = drawn().most_stress.grains,
    at = (v) => (v / top) * length;
  return s(
    "g",
    {},
    label(0, 8, "\u03c3_{norm} = \u03c3_{hyd} / \u27e8\u03c3_{hyd}\u27e9", null, { fill: theme.ink }),
    bar(theme.stress, 0, 24, length, 11),
    [0, 1, top].map((v) =>
      label(at(v), 46, `${v === top ? "\u2265\u202f" : ""}${v}`, v === 0 ? null : v === top ? "end" : "middle"),
    ),
  );
}

/** What is drawn over the map, as far as one row holds it. */
function lineKey(film, camera, theme, state) {
  const group = s("g", { transform: "translate(0 81)" });
  const bare = state.get("grains") === "stress",
    { marks, cyclic } = film.about.maps[state.get("map")];
  let x = marks && !bare ? 148 : 1;
  const add = (shape, words) => {
    const wide = 27 + 6.2 * words.replace(/[_{}]/g, "").length;
    if (x + wide > camera.width) return;
    group.append(shape(x), label(x + 27, 0, words));
    x += wide + 15;
  };
  if (cyclic && !bare) {
    group.append(label(x, 0, `pale: below ${film.about.faint_below} standard errors`));
    x += 190;
  }
  if (state.get("grains") === "material")
    film.materials.forEach(({ name }, m) =>
      add(
        (at) =>
          s("circle", { cx: at + 13, cy: 0, r: 5.5, fill: "none", stroke: materialLine(theme, m), "stroke-width": 2 }),
        name,
      ),
    );
  if (state.get("forces") && film.hasForces) {
    const stroke = Math.min(10, Math.max(1, barWidth(film, film.meanForce) * camera.scale));
    add(
      (at) =>
        s("line", {
          x1: at + 5,
          x2: at + 17,
          y1: 0,
          y2: 0,
          stroke: theme.strong,
          "stroke-width": stroke,
          "stroke-linecap": "round",
        }),
      `\u27e8F_{n}\u27e9 = ${text.quantity(film.meanForce, film.contacts.fn.unit)}`,
    );
    add(
      (at) =>
        s("line", {
          x1: at,
          x2: at + 22,
          y1: 0,
          y2: 0,
          stroke: theme.strong,
          "stroke-width": 1.3,
          "stroke-dasharray": "3 4",
        }),
      "may be absent",
    );
  }
  if (state.get("motion") && film.grains.motion_x)
    add(
      (at) =>
        s("path", {
          d: `M${at},0h13v-3.5l7,3.5l-7,3.5v-3.5`,
          fill: theme.accent,
          stroke: theme.accent,
          "stroke-width": 1.4,
        }),
      `motion \u00d7 ${text.number(magnification(film), 1)}`,
    );
  return group;
}
