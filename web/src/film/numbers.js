import { h, rich } from "../dom.js";
import { known, sourceName } from "../figures/film_grains.js";
import { grid } from "../numbers.js";
import { prefixOf } from "../text.js";

/** The statistics of grain stresses in film and simulation beside each other, and how they agree grain by grain. */
export function comparisonNumbers(film) {
  const shown = known(film).filter(([name]) => film.stresses[name].statistics.count);
  if (shown.length === 0) return null;
  const tables = [...shown.map(([name, title]) => stresses(film, name, title)), ...agreement(film, shown)];
  return h("section", { class: "card numbers" }, h("div", { class: "title" }, h("h3", {}, film.hasSimulation ? "Experiment and simulation" : "Stress of grains")),
    h("div", { class: "tables even" }, tables),
    h("p", { class: "caption" }, rich("\u03c3_{hyd}, P_{0}, \u03b2: grains away from the border; each set over its own mean. Agreement: all grains; slope of the film on the simulation.")));
}

function stresses(film, name, title) {
  const { by_material: parts = {}, ...all } = film.stresses[name].statistics, rows = [["all", all], ...Object.entries(parts)];
  const { factor, prefix } = prefixOf(Math.max(...rows.map(([, d]) => Math.abs(d.mean_Pa?.value ?? 0))), "Pa");
  return grid(title, rows, [
    { head: "grains", of: (d) => d.count }, { head: "\u27e8\u03c3_{hyd}\u27e9", unit: `${prefix}Pa`, scale: 1 / factor, of: (d) => d.mean_Pa },
    { head: "P_{0}", unit: "%", scale: 100, of: (d) => d.P0 }, { head: "\u03b2", of: (d) => d.beta },
  ]);
}

function agreement(film, shown) {
  const { factor, prefix } = prefixOf(Math.abs(film.stresses.film?.mean), "Pa");
  return shown.filter(([name]) => film.about.agreement[name]).map(([name]) =>
    grid(`Agreement with the simulation, ${sourceName(name)}`, Object.entries(film.about.agreement[name]), [
      { head: "grains", of: (a) => a.count }, { head: "r", of: (a) => a.correlation }, { head: "slope", of: (a) => a.slope },
      { head: "r.m.s. difference", unit: `${prefix}Pa`, scale: 1 / factor, digits: 3, of: (a) => a.rms_Pa },
    ]));
}
