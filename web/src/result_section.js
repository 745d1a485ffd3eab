import { keepInAddress } from "./address.js";
import { h } from "./dom.js";
import { figureCard } from "./figures/card.js";
import { figuresOf } from "./figures/index.js";
import { headlines, resultNumbers, tilesOf } from "./numbers.js";
import { State } from "./state.js";

/** What the reader may choose on the section of a result; `kept`: what of it the address keeps, by the result's
    name. */
export function choicesOf(result, page, choices, kept = null) {
  const state = new State({ theme: page.get("theme"), ...choices });
  if (kept) keepInAddress(state, kept, `${result.name}-`);
  page.watch(["theme"], () => state.set({ theme: page.get("theme") }));
  return state;
}

/** The section of a field, a film or a sample in space: its panel beside headlines and figures, tables below. `cards`
    stand before the figures, `remarks` after them and `tables` before all numbers; `own` has cards by the ids of the
    figures in whose places they stand, null where there is nothing to show. */
export function resultSection(result, state, heads, { panel, cards = [], remarks = [], tables = [], own = {} }) {
  const figures = figuresOf(heads)
    .filter(({ id, when }) => (id in own ? own[id] : when({}, result)))
    .map((figure) => own[figure.id] ?? figureCard(figure, result, state));
  const tiles = headlines(tilesOf(result.declared, result.about.headlines));
  return h(
    "div",
    {},
    h(
      "main",
      {},
      panel,
      h("div", { class: "results" }, tiles, cards, h("div", { class: "figures" }, figures), remarks),
    ),
    tables,
    resultNumbers(result.declared),
  );
}
