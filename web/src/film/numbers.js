import { h, rich } from "../dom.js";
import { known, sourceName } from "../figures/film_grains.js";
import { grid } from "../numbers.js";

/** The statistics of grain stresses in film and simulation beside each other, and how they agree grain by grain. */
export function comparisonNumbers(film) {
  const stresses = film.declared.in("stresses"),
    agreement = film.declared.in("agreement"),
    shown = known(film).filter(([name]) => stresses.at(`${name}.count`));
  if (shown.length === 0) return null;
  const tables = [
    ...shown.map(([name, title]) =>
      grid(
        title,
        [["all", stresses.in(name)], ...stresses.in(name).in("by_material").parts],
        [["count", "grains"], ["mean_Pa", "\u27e8\u03c3_{hyd}\u27e9"], "P0", "beta"],
      ),
    ),
    ...shown
      .filter(([name]) => agreement.at(name))
      .map(([name]) =>
        grid(`Agreement with the simulation, ${sourceName(name)}`, agreement.in(name).parts, [
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
    h("div", { class: "title" }, h("h3", {}, film.hasSimulation ? "Experiment and simulation" : "Stress of grains")),
    h("div", { class: "tables even" }, tables),
    h(
      "p",
      { class: "caption" },
      rich(
        "Grains away from the border; \u03c3_{norm} of each set is over its own mean. " +
          "Agreement: correlation, slope of the film on the simulation, r.m.s. difference.",
      ),
    ),
  );
}
