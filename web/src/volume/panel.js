import { choice, toggle } from "../choice.js";
import { h } from "../dom.js";
import { componentChoice, isField, only, scaleChoices } from "../field/scale_controls.js";
import { saveButtons } from "../save_buttons.js";
import { axes } from "../space/frame.js";
import { slider } from "../space/slider.js";
import { text } from "../text.js";
import { levels } from "./result.js";
import { VolumeView } from "./view.js";

/** The card with the sample in space: what its colours are, what is cut away, and the picture. */
export function volumePanel(result, state) {
  const view = new VolumeView(result, state);
  const panel = h(
    "section",
    { class: "card packing sample", "aria-label": "Sample" },
    h(
      "div",
      { class: "controls" },
      choice("Show", "show", state, [["phases", "Phases"], ...(result.offered.length ? [["field", "Field"]] : [])]),
      only(state, isField, componentChoice(result, state)),
      view.scene && saveButtons("the picture", { svg: () => view.saveSvg(), png: () => view.savePng() }),
    ),
    only(
      state,
      isField,
      h("div", { class: "controls second" }, scaleChoices(state), view.scene && level(result, state)),
    ),
    view.scene && h("div", { class: "controls second" }, switches(result, state), cuts(result, state)),
    view.element,
    note(result),
  );
  return { panel, view };
}

function switches(result, state) {
  return h(
    "div",
    { class: "choice overlays" },
    result.phases.length > 1 && [
      toggle("Matrix", "matrix", state, "Off: the matrix is transparent"),
      toggle("Grains", "particle", state, "Off: the grains are transparent"),
    ],
    toggle("Surface", "surface", state, "On: what is seen has a smooth surface; off: the faces of its voxels"),
    toggle("Slices", "lines", state, "Dashed lines where the slices cut the faces of the sample"),
  );
}

/** Voxels whose value is below this are transparent: what is left ends at a level surface of the field. */
const level = (result, state) =>
  slider(
    "\u2265",
    "Voxels whose value is below this are transparent",
    "level",
    state,
    [0, levels],
    (part) => {
      const name = state.get("component"),
        value = result.valueOfCode(name, result.codeOfLevel(part));
      return part === 0 ? "all" : text.quantity(value, result.unitOf(name));
    },
    "choice threshold level",
  );

/** In voxels a number alone, for which there is room. */
const lengthOf = (result, kept) =>
  result.inVoxels ? text.count(kept * result.about.stride) : result.length(result.place(kept, 0));

/** What lies beyond these places is cut away. */
const cuts = (result, state) =>
  h(
    "div",
    { class: "cuts" },
    axes.map((axis, a) =>
      slider(
        `${axis}\u2009\u2264`,
        `What is kept along ${axis}; the rest is cut away`,
        `cut${axis}`,
        state,
        [1, result.size[a]],
        (kept) => (kept === result.size[a] ? "all" : lengthOf(result, kept)),
      ),
    ),
  );

function note({ about: { stride, full } }) {
  if (stride === 1) return null;
  const every = `${stride}${stride === 2 ? "nd" : stride === 3 ? "rd" : "th"}`;
  return h(
    "p",
    { class: "caption note" },
    `The sample has ${full.map(text.count).join(" \u00d7 ")} voxels: every ${every} along each axis is drawn; ` +
      "means and tables include all.",
  );
}
