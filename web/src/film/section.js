import { h } from "../dom.js";
import { figureCard } from "../figures/card.js";
import { figuresOf } from "../figures/index.js";
import { headlines, resultNumbers, tilesOf } from "../numbers.js";
import { textureCard } from "../packing/texture.js";
import { State } from "../state.js";
import { comparisonNumbers } from "./numbers.js";
import { available } from "./maps.js";
import { filmPanel } from "./panel.js";

/** What the reader may choose on the section of a film. */
function begin(film, page) {
  const known = available(film),
    map = ["in_phase", "amplitude", "picture"].find((name) => known.includes(name)) ?? known[0];
  return new State({
    theme: page.get("theme"),
    map,
    law: "linear",
    clip: "1",
    grains: film.count ? "rims" : "off",
    forces: false,
    motion: false,
    component: "fn",
    companion: film.stresses.simulation_peak_to_peak ? "peak_to_peak" : "state",
    over: "mean",
  });
}

/** A film with its figures and tables: { element, state, view, film }. */
export function filmSection(film, page, heads) {
  const state = begin(film, page);
  page.watch(["theme"], () => state.set({ theme: page.get("theme") }));
  const { panel, view } = available(film).length
    ? filmPanel(film, state)
    : { panel: h("section", { class: "card" }, h("p", { class: "nothing" }, "This film has no maps.")), view: null };
  const shown = figuresOf(heads).filter((figure) => figure.when({}, film));
  const cards = shown.map((figure) => figureCard(figure, film, state));
  const tiles = headlines(tilesOf(film.declared, film.about.headlines));
  const element = h(
    "div",
    {},
    h(
      "main",
      {},
      panel,
      h("div", { class: "results" }, tiles, h("div", { class: "figures" }, cards), missing(film)),
    ),
    [
      comparisonNumbers(film),
      film.declared.at("texture") && textureCard("Microstructure and forces", film.declared.in("texture")),
      resultNumbers(film.declared),
    ],
  );
  return { element, state, view, film };
}

/** What cannot be shown, and why. */
function missing(film) {
  const sentences = [
    !film.count && "No grains were found in this film, so stresses and forces are not shown.",
    film.count > 0 && !film.stresses.film && "Stresses of the grains were not measured.",
    film.count > 0 && !film.hasForces && "Contact forces were not inferred.",
    film.stresses.film && !film.hasSimulation && "No simulation of the same grains accompanies this film.",
  ].filter(Boolean);
  for (const doubt of film.declared.at("checks.doubts") ?? [])
    sentences.push(`${doubt[0].toUpperCase()}${doubt.slice(1)}.`);
  return sentences.length ? h("p", { class: "caption missing" }, sentences.join(" ")) : null;
}
