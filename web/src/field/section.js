import { forms, keepInAddress } from "../address.js";
import { h } from "../dom.js";
import { figureCard } from "../figures/card.js";
import { figuresOf } from "../figures/index.js";
import { headlines, resultNumbers, tilesOf } from "../numbers.js";
import { State } from "../state.js";
import { fieldPanel } from "./panel.js";

/** What the reader may choose on the section of one result. */
function begin(result, page) {
  const mean = result.mean ?? 0,
    tension = Math.abs(mean) > 0.3 * result.scale;
  const component = tension ? "yy" : "xy";
  return new State({
    theme: page.get("theme"),
    show: result.loaded && !result.cracks ? "field" : "phases",
    component,
    around: "mean",
    law: "linear",
    clip: "0.1",
    by: "node",
    chains: false,
    threshold: 1,
    outlines: result.map.counts.length > 0 && result.map.grainClass.length < 3000,
    crosses: false,
    cavities: "any",
    norm: "sample",
    cracks: Boolean(result.cracks),
    step: Math.max(0, result.steps - 1),
    playing: false,
    grain: 0,
    deform: 0,
  });
}

/** One result on a grid with its figures and tables: { element, state, view }. */
export function fieldSection(result, page, heads) {
  const state = begin(result, page);
  keepInAddress(
    state,
    {
      show: forms.word(["phases", "field"]),
      component: forms.word(result.offered),
      step: forms.whole(result.steps),
      grain: forms.whole(result.grains.nodes.length + 1),
      deform: forms.share,
    },
    `${result.name}-`,
  );
  page.watch(["theme"], () => state.set({ theme: page.get("theme") }));
  const { panel, view } = fieldPanel(result, state, result.title);
  const figures = figuresOf(heads)
    .filter((figure) => figure.when({}, result))
    .map((figure) => figureCard(figure, result, state));
  const tiles = headlines(tilesOf(result.declared, result.about.headlines));
  const element = h(
    "div",
    {},
    h(
      "main",
      {},
      panel,
      h("div", { class: "results" }, tiles, h("div", { class: "figures" }, figures)),
    ),
    resultNumbers(result.declared),
  );
  return { element, state, view, result };
}
