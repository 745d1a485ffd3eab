import { forms, keepInAddress } from "../address.js";
import { h } from "../dom.js";
import { figureCard } from "../figures/card.js";
import { figuresOf } from "../figures/index.js";
import { headlines, resultNumbers, tilesOf } from "../numbers.js";
import { State } from "../state.js";
import { volumePanel } from "./panel.js";
import { axes } from "./result.js";
import { slicesCard } from "./slices.js";
import { firstLook } from "./view.js";

/** What the reader may choose on the section of a sample in space: three slices through its middle, and all of it. */
function begin(result, page) {
  return new State({
    theme: page.get("theme"),
    show: result.offered.length ? "field" : "phases",
    component: result.loaded,
    around: "mean",
    law: "linear",
    clip: "0.1",
    norm: "sample",
    matrix: true,
    particle: true,
    lines: true,
    ...firstLook,
    ...Object.fromEntries(axes.map((axis, a) => [axis, Math.floor(result.size[a] / 2)])),
    ...Object.fromEntries(axes.map((axis, a) => [`cut${axis}`, result.size[a]])),
  });
}

/** What of it is kept in the address. */
const kept = (result) => ({
  show: forms.word(["phases", "field"]),
  component: forms.word(result.offered),
  matrix: forms.truth,
  particle: forms.truth,
  azimuth: forms.between(0, 360),
  elevation: forms.between(-90, 90),
  zoom: forms.between(0.5, 40),
  ...Object.fromEntries(axes.map((axis, a) => [axis, forms.between(0, result.size[a] - 1, true)])),
  ...Object.fromEntries(axes.map((axis, a) => [`cut${axis}`, forms.between(1, result.size[a], true)])),
});

/** A sample in space with its slices, figures and tables: { element, state, view, slices, result }. */
export function volumeSection(result, page, heads) {
  const state = begin(result, page);
  keepInAddress(state, kept(result), `${result.name}-`);
  page.watch(["theme"], () => state.set({ theme: page.get("theme") }));
  const { panel, view } = volumePanel(result, state),
    { card, slices } = slicesCard(result, state);
  const figures = figuresOf(heads)
    .filter((figure) => figure.when({}, result))
    .map((figure) => figureCard(figure, result, state));
  const tiles = headlines(tilesOf(result.declared, result.about.headlines));
  const element = h(
    "div",
    {},
    h("main", {}, panel, h("div", { class: "results" }, tiles, card, h("div", { class: "figures" }, figures))),
    resultNumbers(result.declared),
  );
  return { element, state, view, slices, result };
}
