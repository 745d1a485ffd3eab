import { forms } from "../address.js";
import { choice, toggle } from "../choice.js";
import { h } from "../dom.js";
import { only, scaleChoices } from "../field/scale_controls.js";
import { begins, known } from "../figures/grain_scatter.js";
import { grainTable } from "../grain_table.js";
import { choicesOf, resultSection } from "../result_section.js";
import { timeline } from "../packing/timeline.js";
import { saveButtons } from "../save_buttons.js";
import { axes } from "../space/frame.js";
import { slider } from "../space/slider.js";
import { firstLook, lookForms } from "../space/view.js";
import { text } from "../text.js";
import { fieldSlices } from "./field_slices.js";
import { cuts } from "./result.js";
import { SphereView } from "./view.js";

/** What the reader may choose, as it is in the beginning: of coarse-grained fields slices through their middle. */
export const choices = (result, fields = null) => ({
  snapshot: Math.max(0, result.snapshotCount - 1),
  playing: false,
  half: "above",
  turned: `${firstLook().azimuth} ${firstLook().elevation}`,
  show: result.offered[0] ?? "material",
  around: "mean",
  law: "linear",
  clip: "1",
  chains: false,
  bonds: result.hasBonds,
  boundaries: result.hasBoundaries,
  spheres: true,
  selected: null, // the sphere that was clicked, in the picture, the table or a chart
  pointed: null, // the sphere whose row or point the pointer is on
  ...begins(result),
  ...firstLook(),
  ...Object.fromEntries(axes.map((axis) => [`cut${axis}`, cuts[1]])),
  ...(fields && {
    field: fields.offered.some(([name]) => name === "vx") ? "speed" : "solid_fraction",
    ...Object.fromEntries(axes.map((axis, a) => [axis, Math.floor(fields.size[a] / 2)])),
  }),
});

/** What of it is kept in the address. */
const kept = (result, fields) => ({
  snapshot: forms.whole(Math.max(1, result.snapshotCount)),
  half: forms.word(["above", "turned"]),
  show: forms.word(["material", ...result.offered]),
  ...(result.hasForces && { chains: forms.truth }),
  ...(result.hasBonds && { bonds: forms.truth }),
  ...(result.hasBoundaries && { boundaries: forms.truth }),
  spheres: forms.truth,
  selected: forms.whole(result.count),
  across: forms.word(known(result).map(([name]) => name)),
  up: forms.word(known(result).map(([name]) => name)),
  ...lookForms,
  ...Object.fromEntries(axes.map((axis) => [`cut${axis}`, forms.between(...cuts, true)])),
  ...(fields && {
    field: forms.word(fields.offered.map(([name]) => name)),
    ...Object.fromEntries(axes.map((axis, a) => [axis, forms.between(0, fields.size[a] - 1, true)])),
  }),
});

/** A stage of a sample of spheres with its picture, figures and tables: { element, state, view, result }, and { slices,
    fields } where it has coarse-grained fields. */
export function sphereSection(result, page, heads) {
  const fields = result.coarseFields(),
    state = choicesOf(result, page, choices(result, fields), kept(result, fields)),
    view = new SphereView(result, state);
  const head = heads.find(({ id }) => id === "coarse-fields"),
    { card = null, ...ofFields } = fields ? fieldSlices(fields, state, head) : {};
  const element = resultSection(result, state, heads, {
    panel: panelOf(result, state, view),
    own: { [head.id]: card },
    tables: [grainTable(result, state, tableWords(result))],
  });
  return { element, state, view, result, ...ofFields };
}

const tableWords = ({ title, name }) => ({
  noun: "sphere",
  states: "the state shown",
  symbols: "p: mean of the principal stresses of a sphere, compression positive. ",
  file: [title, name],
});

const isScaled = (show) => show !== "material";

/** The card with the spheres: what their colours are, which are hidden, and the picture. */
export const panelOf = (result, state, view) =>
  h(
    "section",
    { class: "card packing sample", "aria-label": "Spheres" },
    h(
      "div",
      { class: "controls" },
      choice(
        "Show",
        "show",
        state,
        [["material", "Material"], ...result.offered.map((id) => [id, result.quantity(id).label])],
      ),
      view.scene && saveButtons("the picture", { svg: () => view.saveSvg(), png: () => view.savePng() }),
    ),
    only(state, isScaled, h("div", { class: "controls second" }, scaleChoices(state, [["all", "0"]]))),
    view.scene && h("div", { class: "controls second" }, switches(result, state), cutsOf(result, state)),
    view.element,
    result.snapshotCount > 1 && timeline(statesOf(result), state),
    notes(result, state),
  );

/** The states as the slider asks for them. */
const statesOf = ({ name, states, snapshotCount }) => ({
  snapshotCount,
  stages: [{ name }],
  about: { snapshots: states.map(({ label, time }) => ({ stage: 0, label, time })) },
});

const switches = (result, state) =>
  h(
    "div",
    { class: "choice overlays" },
    result.hasForces &&
      toggle("Forces", "chains", state, "Lines between spheres as thick as their normal force; spheres are pale"),
    result.hasBonds && toggle("Bonds", "bonds", state, "Rods between bonded spheres, balls where bonds broke"),
    result.hasBoundaries && toggle("Boundaries", "boundaries", state, "Edges of the faces of boundaries"),
    (result.hasForces || result.hasBonds || result.hasBoundaries) &&
      toggle("Spheres", "spheres", state, "Off: the spheres are not drawn"),
  );

const cutsOf = (result, state) =>
  h(
    "div",
    { class: "cuts" },
    axes.map((axis, a) =>
      slider(
        `${axis}\u2009\u2264`,
        `Spheres whose centres lie beyond along ${axis} are hidden; counted from the lowest corner`,
        `cut${axis}`,
        state,
        cuts,
        (cut) => result.length(a, cut),
      ),
    ),
  );

/** What is left out, and of which state the figures are. */
function notes(result, state) {
  const forces = h("p", { class: "caption note" });
  const refresh = () => {
    const { all, fn } = result.state.forces;
    forces.hidden = all === fn.length;
    forces.textContent = `Of ${text.count(all)} forces the ${text.count(fn.length)} largest are drawn.`;
  };
  state.watch(["snapshot"], refresh);
  refresh();
  return [forces, result.about.note && h("p", { class: "caption note" }, result.about.note)];
}
