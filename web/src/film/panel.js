import { choice, toggle } from "../choice.js";
import { h } from "../dom.js";
import { available } from "./maps.js";
import { FilmView } from "./view.js";

/** The card with the film: which map, what lies over it, the picture. */
export function filmPanel(film, state) {
  const view = new FilmView(film, state);
  const scale = h(
    "div",
    { class: "controls" },
    choice("", "law", state, [
      ["linear", "Linear"],
      ["symlog", "Symlog"],
    ]),
    choice("Clip", "clip", state, [
      ["all", "0"],
      ["0.1", "0.1"],
      ["1", "1"],
      ["5", "5\u202f%"],
    ]),
  );
  const refresh = () => {
    scale.hidden = film.about.maps[state.get("map")].cyclic;
  };
  state.watch(["map"], refresh);
  refresh();
  const panel = h(
    "section",
    { class: "card packing sample", "aria-label": "Film" },
    h(
      "div",
      { class: "controls" },
      choice(
        "",
        "map",
        state,
        available(film).map((name) => [name, film.about.maps[name].label]),
      ),
      h(
        "span",
        { class: "saves" },
        h(
          "button",
          {
            class: "save",
            title: "Save the picture as SVG",
            "aria-label": "Save the picture of the film as SVG",
            onclick: () => view.saveSvg(),
          },
          "SVG",
        ),
        h(
          "button",
          {
            class: "save",
            title: "Save the picture as PNG",
            "aria-label": "Save the picture of the film as PNG",
            onclick: () => view.savePng(),
          },
          "PNG",
        ),
      ),
    ),
    h("div", { class: "controls second" }, overlays(film, state), scale),
    view.element,
  );
  return { panel, view };
}

function overlays(film, state) {
  if (!film.count) return null;
  const fills = [
    ["off", "Off"],
    ["rims", "Rims"],
    ...(film.materials.length ? [["material", "Material"]] : []),
    ...(film.stresses.film ? [["stress", "\u03c3_{norm}"]] : []),
  ];
  return h(
    "div",
    { class: "controls" },
    choice("Grains", "grains", state, fills),
    h(
      "div",
      { class: "choice overlays" },
      film.hasForces &&
        toggle(
          "Forces",
          "forces",
          state,
          "Contact forces as bars of thickness F_n; pale: plus one standard error; dashed: may be absent",
        ),
      film.grains.motion_x &&
        toggle("Motion", "motion", state, "Motion of each grain from the smallest to the largest load, magnified"),
    ),
  );
}
