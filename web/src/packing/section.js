import { forms, keepInAddress } from "../address.js";
import { h } from "../dom.js";
import { figureCard } from "../figures/card.js";
import { layers } from "../figures/coarse_fields.js";
import { begins, known } from "../figures/grain_scatter.js";
import { figuresOf } from "../figures/index.js";
import { grainTable } from "../grain_table.js";
import { State } from "../state.js";
import { colouringsOf } from "./colouring.js";
import { packingPanel } from "./panel.js";
import { loadsCard, numbersTable, packingHeadlines } from "./texture.js";

function begin(sample, page) {
  return new State({
    theme: page.get("theme"),
    snapshot: sample.opening,
    playing: false,
    colour: "material",
    chains: true,
    strength: "all",
    types: new Set(sample.types.keys()),
    marks: false,
    scales: {}, // what the reader changed of the colours, by colouring
    selected: null, // the grain that was clicked, in the picture, the table or a chart
    pointed: null, // the grain whose row or point the pointer is on
    ...begins(sample),
    field: sample.fields(sample.snapshotCount - 1)?.vx ? "speed" : "solid_fraction",
  });
}

/** What a link to the page keeps of the reader's choice. */
function keep(sample, state) {
  const names = known(sample).map(([name]) => name);
  keepInAddress(state, {
    snapshot: forms.whole(sample.snapshotCount),
    colour: forms.word(colouringsOf(sample).map(([mode]) => mode)),
    scales: forms.tree,
    chains: forms.truth,
    strength: forms.word(["all", "strong", "weak", "tensile"]),
    marks: forms.truth,
    selected: forms.whole(sample.count),
    across: forms.word(names),
    up: forms.word(names),
    field: forms.word(Object.keys(layers)),
  });
}

const tableWords = (sample) => ({
  noun: "grain",
  states: sample.exchanges ? "all states, those of the state shown in the table" : "the state shown",
  symbols:
    "p, q: half the sum and half the difference of the principal stresses of a grain, compression positive; " +
    "u, \u03b8: since the first state of the stage; \u03b8, \u03c9: counter-clockwise. ",
  file: [sample.title],
});

/** The packing with its figures and tables: { element, sample, state, view }. */
export function packingSection(sample, page) {
  const state = begin(sample, page);
  keep(sample, state);
  page.watch(["theme"], () => state.set({ theme: page.get("theme") }));
  const texture = sample.texture(state.get("snapshot"));
  const drawable = figuresOf(sample.about.figures.stage).filter((figure) => figure.when(texture ?? {}, sample));
  const { panel, view } = packingPanel(sample, state);
  const cards = h(
    "div",
    { class: "figures" },
    drawable.map((figure) => figureCard(figure, sample, state)),
  );
  const element = h(
    "div",
    {},
    h(
      "main",
      {},
      panel,
      h("div", { class: "results" }, packingHeadlines(sample, state), loadsCard(sample, state), cards),
    ),
    numbersTable(sample, state),
    grainTable(sample, state, tableWords(sample)),
  );
  return { element, sample, state, view };
}
