import { h } from "../dom.js";
import { usualClip } from "../field/scale.js";
import { textureCard } from "../packing/texture.js";
import { choicesOf, resultSection } from "../result_section.js";
import { capital } from "../text.js";
import { comparisonNumbers } from "./numbers.js";
import { available } from "./maps.js";
import { filmPanel } from "./panel.js";

/** What the reader may choose on the section of a film. */
function choices(film) {
  const known = available(film),
    map = ["in_phase", "amplitude", "picture"].find((name) => known.includes(name)) ?? known[0];
  return {
    map,
    law: "linear",
    clip: usualClip("pixels"),
    grains: film.count ? "rims" : "off",
    forces: false,
    motion: false,
    component: "fn",
    companion: film.stresses.simulation_peak_to_peak ? "peak_to_peak" : "state",
    over: "mean",
  };
}

/** A film with its figures and tables: { element, state, view, film }. */
export function filmSection(film, page, heads) {
  const state = choicesOf(film, page, choices(film));
  const { panel, view } = available(film).length
    ? filmPanel(film, state)
    : { panel: h("section", { class: "card" }, h("p", { class: "nothing" }, "This film has no maps.")), view: null };
  const tables = [
    comparisonNumbers(film),
    film.declared.at("texture") && textureCard("Microstructure and forces", film.declared.in("texture")),
  ];
  const element = resultSection(film, state, heads, { panel, remarks: missing(film), tables });
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
    sentences.push(`${capital(doubt)}.`);
  return sentences.length ? h("p", { class: "caption missing" }, sentences.join(" ")) : null;
}
