import { choice, toggle } from "../choice.js";
import { h, rich } from "../dom.js";
import { text } from "../text.js";
import { cavityKinds } from "./cavities.js";
import { magnification } from "./deformation.js";
import { Picture } from "./picture.js";
import { componentChoice, isField, only, scaleChoices } from "./scale_controls.js";
import { stepSlider } from "./steps.js";
import { FieldView } from "./view.js";

/** The card with the sample: what to paint on the nodes, how, the picture, and for a test to failure the slider. */
export function fieldPanel(result, state, title) {
  const view = new FieldView(result, state),
    picture = new Picture(view, title);
  const panel = h(
    "section",
    { class: "card packing sample", "aria-label": "Sample" },
    h(
      "div",
      { class: "controls" },
      choice("Show", "show", state, shows(result)),
      only(state, isField, componentChoice(result, state)),
      h(
        "span",
        { class: "saves" },
        h(
          "button",
          {
            class: "save",
            title: "Save the picture as SVG",
            "aria-label": `Save the picture of \u201c${title}\u201d as SVG`,
            onclick: () => picture.saveSvg(),
          },
          "SVG",
        ),
        h(
          "button",
          {
            class: "save",
            title: "Save the picture as PNG",
            "aria-label": `Save the picture of \u201c${title}\u201d as PNG`,
            onclick: () => picture.savePng(),
          },
          "PNG",
        ),
      ),
    ),
    h("div", { class: "controls second" }, scaleControls(state), cavityControls(state)),
    h(
      "div",
      { class: "controls second" },
      fieldOverlays(state),
      overlays(result, state),
      result.has("ux") ? deformationControl(result, state) : null,
    ),
    view.element,
    note(result),
    result.steps > 1 ? stepSlider(result, state) : null,
  );
  return { panel, view };
}

function shows(result) {
  const cavities = Object.entries(cavityKinds).filter(([kind]) => result.map.cavities?.[kind]?.nodes.length > 0);
  return [["phases", "Phases"], ...(result.loaded ? [["field", "Field"]] : []), ...cavities];
}

const scaleControls = (state) =>
  only(state, isField, h("div", { class: "controls" }, scaleChoices(state, [["all", "0"]])));

function fieldOverlays(state) {
  return only(
    state,
    isField,
    h(
      "div",
      { class: "controls" },
      choice("", "by", state, [
        ["node", "Nodes"],
        ["grain", "Grain means"],
      ]),
      thresholdControl(state),
    ),
  );
}

/** Stress chains: what is below so many times the mean steps back. */
function thresholdControl(state) {
  const output = h("output");
  const slider = h("input", {
    type: "range",
    min: 0,
    max: 4,
    step: 0.1,
    "aria-label": "Minimum stress over the mean",
    oninput: (event) => state.set({ threshold: Number(event.target.value) }),
  });
  const refresh = () => {
    slider.value = state.get("threshold");
    slider.disabled = !state.get("chains");
    slider.style.setProperty("--done", `${25 * state.get("threshold")}%`);
    output.replaceChildren(...rich(`${text.number(state.get("threshold"), 2)}\u2009\u00d7\u2009mean`));
  };
  state.watch(["threshold", "chains"], refresh);
  refresh();
  return h(
    "div",
    { class: "choice threshold" },
    toggle("Chains", "chains", state, "Only stresses above this multiple of the mean"),
    h("div", { class: "track" }, slider),
    output,
  );
}

/** How far nodes are drawn from where they were. */
function deformationControl(result, state) {
  const output = h("output");
  const slider = h("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 0.02,
    "data-slider": "deform",
    "aria-label": "Magnification of the deformation",
    oninput: (event) => state.set({ deform: Number(event.target.value) }),
  });
  const refresh = () => {
    const share = state.get("deform");
    slider.value = share;
    slider.style.setProperty("--done", `${100 * share}%`);
    output.textContent = share > 0 ? `\u00d7\u2009${text.number(magnification(result, share), 2)}` : "none";
  };
  state.watch(["deform"], refresh);
  refresh();
  const title = result.cracks ? "Displacements at the largest stress, magnified" : "Displacements, magnified";
  return h(
    "div",
    { class: "choice threshold", title },
    h("span", { class: "name" }, "Deformed"),
    h("div", { class: "track" }, slider),
    output,
  );
}

function cavityControls(state) {
  return only(
    state,
    (show) => show in cavityKinds,
    choice("Colours", "cavities", state, [
      ["any", "Any"],
      ["size", "By size"],
    ]),
  );
}

function overlays(result, state) {
  return h(
    "div",
    { class: "choice overlays" },
    toggle("Outlines", "outlines", state, "Lines between grains, matrix and void"),
    result.loaded &&
      toggle(
        "Crosses",
        "crosses",
        state,
        "Crosses: mean principal stresses of each grain; in the close-up, of its nodes",
      ),
    result.cracks && toggle("Broken bonds", "cracks", state, "A dot at every bond broken up to this step"),
  );
}

function note({ map }) {
  const {
    stride,
    about: {
      full: [width, height],
    },
  } = map;
  if (stride === 1) return null;
  return h(
    "p",
    { class: "caption note" },
    `The map has ${text.count(width)} \u00d7 ${text.count(height)} nodes: every ` +
      `${stride}${stride === 2 ? "nd" : stride === 3 ? "rd" : "th"} in both directions is drawn; ` +
      "means and tables include all nodes.",
  );
}
