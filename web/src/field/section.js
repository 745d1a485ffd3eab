import { forms } from "../address.js";
import { choicesOf, resultSection } from "../result_section.js";
import { fieldPanel } from "./panel.js";
import { usualClip } from "./scale.js";

/** What the reader may choose on the section of one result. */
function choices(result) {
  return {
    show: result.loaded && !result.cracks ? "field" : "phases",
    component: result.actsBy,
    around: "mean",
    law: "linear",
    clip: usualClip("nodes"),
    by: "node",
    chains: false,
    threshold: 1,
    outlines: result.map.grainKind.length < 3000,
    crosses: false,
    cavities: "any",
    norm: "sample",
    cracks: Boolean(result.cracks),
    step: Math.max(0, result.steps - 1),
    playing: false,
    grain: 0,
    deform: 0,
  };
}

/** What of it is kept in the address. */
const kept = (result) => ({
  show: forms.word(["phases", "field"]),
  component: forms.word(result.offered),
  step: forms.whole(result.steps),
  grain: forms.whole(result.grains.nodes.length + 1),
  deform: forms.share,
});

/** One result on a grid with its figures and tables: { element, state, view, result }. */
export function fieldSection(result, page, heads) {
  const state = choicesOf(result, page, choices(result), kept(result));
  const { panel, view } = fieldPanel(result, state, result.title);
  return { element: resultSection(result, state, heads, { panel }), state, view, result };
}
