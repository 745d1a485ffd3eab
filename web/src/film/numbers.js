import { h, rich } from "../dom.js";
import { known } from "../figures/film_grains.js";
import { grid } from "../numbers.js";

/** The statistics of grain stresses in film and simulation beside each other, and how they agree grain by grain. */
export function comparisonNumbers(film) {
  const { title, caption } = film.about.comparison,
    stresses = film.declared.in("stresses"),
    agreement = film.declared.in("agreement"),
    shown = known(film).filter(([name]) => stresses.at(`${name}.count`));
  if (shown.length === 0) return null;
  const tables = [
    ...shown.map(([name, words]) =>
      grid(
        words,
        [["all", stresses.in(name)], ...stresses.in(name).in("by_material").parts],
        [["count", "grains"], ["mean_Pa", "\u27e8\u03c3_{hyd}\u27e9"], "P0", "beta"],
      ),
    ),
    ...shown
      .filter(([name]) => agreement.at(name))
      .map(([name]) =>
        grid(`Agreement with the ${film.stresses[name].name}`, agreement.in(name).parts, [
          ["count", "grains"],
          ["correlation", "r"],
          "slope",
          "rms_Pa",
        ]),
      ),
  ];
  return h(
    "section",
    { class: "card numbers" },
    h("div", { class: "title" }, h("h3", {}, title)),
    h("div", { class: "tables even" }, tables),
    h("p", { class: "caption" }, rich(caption)),
  );
}
