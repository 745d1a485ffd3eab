import { h } from "../dom.js";
import { figureCard } from "../figures/card.js";
import { figures } from "../figures/index.js";
import { headlines, numbersTable } from "../numbers.js";
import { State } from "../state.js";
import { packingPanel } from "./panel.js";

function begin(sample, page) {
  return new State({
    theme: page.get("theme"),
    frame: sample.frameCount - 1,
    playing: false,
    colour: "material",
    chains: true,
    strength: "all",
    types: new Set(sample.types.keys()),
    marks: false,
  });
}

/** The packing with its figures and tables: { element, sample, state, view }. */
export function packingSection(sample, page) {
  const state = begin(sample, page);
  page.watch(["theme"], () => state.set({ theme: page.get("theme") }));
  const texture = sample.texture(state.get("frame"));
  const drawable = figures.filter((figure) => figure.when(texture ?? {}, sample));
  const { panel, view } = packingPanel(sample, state);
  const cards = h("div", { class: "figures" }, drawable.map((figure) => figureCard(figure, sample, state)));
  const element = h("div", {}, h("main", {}, panel, h("div", { class: "results" }, headlines(sample, state), cards)), numbersTable(sample, state));
  return { element, sample, state, view };
}
