import { h } from "./dom.js";
import { figureCard } from "./figures/card.js";
import { figures } from "./figures/index.js";
import { header } from "./header.js";
import { headlines, numbersTable } from "./numbers.js";
import { packingPanel } from "./packing/panel.js";
import { provenance } from "./provenance.js";
import { Sample } from "./sample.js";
import { State } from "./state.js";
import { followTheme, preferredTheme } from "./theme.js";

function begin(sample) {
  return new State({
    theme: preferredTheme(),
    frame: sample.frameCount - 1,
    playing: false,
    colour: "material",
    chains: true,
    strength: "all",
    types: new Set(sample.types.keys()),
    marks: false,
  });
}

function figureGrid(sample, state) {
  const texture = sample.texture(state.get("frame"));
  const drawable = figures.filter((figure) => figure.when(texture ?? {}, sample));
  return h("div", { class: "figures" }, drawable.map((figure) => figureCard(figure, sample, state)));
}

async function main() {
  const page = document.getElementById("page");
  try {
    const sample = await Sample.load();
    if (sample.frameCount === 0) throw new Error("this result holds no state of a packing");
    const state = begin(sample);
    followTheme(state);
    const { panel, view } = packingPanel(sample, state);
    page.replaceChildren(header(sample, state), 
      h("main", {}, panel, h("div", { class: "results" }, headlines(sample, state), figureGrid(sample, state))),
      numbersTable(sample, state), provenance(sample));
    document.documentElement.dataset.ready = "true";
    window.arenite = { sample, state, view };
  } catch (error) {
    page.replaceChildren(h("p", { class: "failure" }, `The page cannot be drawn: ${error.message}.`));
    throw error;
  }
}

main();
