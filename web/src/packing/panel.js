import { h } from "../dom.js";
import { pairColour, themeOf } from "../theme.js";
import { text } from "../text.js";
import { colourControls } from "./colour_controls.js";
import { timeline } from "./timeline.js";
import { PackingView } from "./view.js";

/** The card with the packing: what to colour, which chains to show, the picture and the slider over the loading. */
export function packingPanel(sample, state) {
  const view = new PackingView(sample, state);
  const svgButton = h(
    "button",
    { class: "save", "aria-label": "Save the picture of the packing as SVG", onclick: () => view.saveSvg() },
    "SVG",
  );
  const refreshSave = () => {
    svgButton.disabled = !view.fewEnoughForSvg;
    svgButton.title = view.fewEnoughForSvg ? "Save the picture as SVG" : "Too many grains for an SVG: save a PNG";
  };
  state.watch(["chains", "snapshot"], refreshSave);
  refreshSave();
  const panel = h(
    "section",
    { class: "card packing", "aria-label": "Packing" },
    h(
      "div",
      { class: "controls" },
      colourControls(sample, state),
      chainControls(sample, state),
      h(
        "span",
        { class: "saves" },
        svgButton,
        h(
          "button",
          {
            class: "save",
            title: "Save the picture as PNG",
            "aria-label": "Save the picture of the packing as PNG",
            onclick: () => view.savePng(),
          },
          "PNG",
        ),
      ),
    ),
    typeFilter(sample, state),
    view.element,
    timeline(sample, state),
  );
  return { panel, view };
}

/** Chains off, all, strong, weak, tensile in one row: "off" hides them, the rest say which are drawn. */
function chainControls(sample, state) {
  const tensile = sample.about.snapshots.length > 0 && sample.snapshot(sample.snapshotCount - 1).hasTension;
  const options = [
    ["off", "Off"],
    ["all", "All"],
    ["strong", "Strong"],
    ["weak", "Weak"],
    ...(tensile ? [["tensile", "Tensile"]] : []),
  ];
  const pick = (value) => state.set(value === "off" ? { chains: false } : { chains: true, strength: value });
  const buttons = options.map(([value, label]) =>
    h("button", { "data-value": value, onclick: () => pick(value) }, label),
  );
  const refresh = () => {
    const now = state.get("chains") ? state.get("strength") : "off";
    buttons.forEach((b) => b.setAttribute("aria-pressed", b.dataset.value === now));
  };
  state.watch(["chains", "strength"], refresh);
  refresh();
  return h(
    "div",
    { class: "choice", role: "group", "aria-label": "Force chains", "data-choice": "chains" },
    h("span", { class: "name" }, "Force chains"),
    h("div", { class: "segments" }, buttons),
  );
}

function typeFilter(sample, state) {
  const row = h("div", { class: "types", role: "group", "aria-label": "Contact types" });
  const refresh = () => {
    const theme = themeOf(state.get("theme")),
      shown = state.get("types"),
      snapshot = sample.snapshot(state.get("snapshot"));
    row.classList.toggle("idle", !state.get("chains"));
    row.replaceChildren(
      ...sample.types.map((type, t) => {
        const count = snapshot.contacts.type.reduce((sum, other) => sum + (other === t), 0);
        return h(
          "button",
          {
            "data-type": type.key,
            "aria-pressed": String(shown.has(t)),
            disabled: !state.get("chains"),
            onclick: () => state.set({ types: toggled(shown, t) }),
          },
          h("span", { class: "dot", style: `background:${pairColour(theme, type)}` }),
          `${type.label} `,
          h("small", {}, text.count(count)),
        );
      }),
      h(
        "button",
        {
          class: "marks",
          "aria-pressed": String(state.get("marks")),
          title: "Mark the rotation of each grain",
          onclick: () => state.set({ marks: !state.get("marks") }),
        },
        "Rotation",
      ),
    );
  };
  state.watch(["types", "theme", "snapshot", "chains", "marks"], refresh);
  refresh();
  return row;
}

function toggled(set, item) {
  const next = new Set(set);
  if (!next.delete(item)) next.add(item);
  return next;
}
