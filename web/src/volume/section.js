import { forms } from "../address.js";
import { usualClip } from "../field/scale.js";
import { choicesOf, resultSection } from "../result_section.js";
import { axes } from "../space/frame.js";
import { slicesCard } from "../space/slices.js";
import { firstLook, lookForms } from "../space/view.js";
import { legend, legendHeight } from "./legend.js";
import { indexOf, painted, tableOf } from "./paint.js";
import { volumePanel } from "./panel.js";
import { levels } from "./result.js";
import { voxelNumbers } from "./tooltip.js";

/** What the reader may choose on the section of a sample in space: three slices through its middle, and all of it. */
function choices(result) {
  return {
    show: result.offered.length ? "field" : "phases",
    component: result.loaded,
    around: "mean",
    law: "linear",
    clip: usualClip("nodes"),
    norm: "sample",
    matrix: true,
    particle: true,
    lines: true,
    surface: false,
    level: 0,
    ...firstLook(),
    ...Object.fromEntries(axes.map((axis, a) => [axis, Math.floor(result.size[a] / 2)])),
    ...Object.fromEntries(axes.map((axis, a) => [`cut${axis}`, result.size[a]])),
  };
}

/** What of it is kept in the address. */
const kept = (result) => ({
  show: forms.word(["phases", "field"]),
  component: forms.word(result.offered),
  matrix: forms.truth,
  particle: forms.truth,
  surface: forms.truth,
  level: forms.between(0, levels, true),
  ...lookForms,
  ...Object.fromEntries(axes.map((axis, a) => [axis, forms.between(0, result.size[a] - 1, true)])),
  ...Object.fromEntries(axes.map((axis, a) => [`cut${axis}`, forms.between(1, result.size[a], true)])),
});

/** Its slices have the colours of the picture, whose legend is below that. */
const lookOf = (result) => ({
  painted,
  index: (state) => indexOf(result, state),
  table: (state, theme) => tableOf(result, state, theme),
  numbers: (cell, state, theme) => voxelNumbers(result, cell, theme, state.get("component")),
  legend: (state, theme, width) => legend(result, state, theme, width),
  legendHeight,
  title: (state) =>
    `Slices: ${state.get("show") === "field" ? result.quantity(state.get("component")).symbol : "phases"}`,
  name: "Slices",
  file: "slices",
});

/** A sample in space with its slices, figures and tables: { element, state, view, slices, result }. */
export function volumeSection(result, page, heads) {
  const state = choicesOf(result, page, choices(result), kept(result));
  state.watch(["component"], () => state.set({ level: 0 })); // a level of another quantity
  const { panel, view } = volumePanel(result, state),
    { card, slices } = slicesCard(result, state, lookOf(result));
  const element = resultSection(result, state, heads, { panel, cards: card });
  return { element, state, view, slices, result };
}
