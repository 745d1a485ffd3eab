import { picker } from "../choice.js";
import { h } from "../dom.js";
import { colourMaps } from "../theme.js";
import { colouringsOf, scaleOf } from "./colouring.js";
import { withScale } from "./scale.js";

/** What grains are coloured by and, for a quantity, by which map, from where to where, linear or logarithmic. */
export function colourControls(sample, state) {
  const mode = () => state.get("colour"),
    change = (changes) => state.set(withScale(state, mode(), changes));
  const end = (name, label) =>
    h("input", {
      type: "number",
      step: "any",
      class: "range-end",
      "data-range": name,
      "aria-label": label,
      onchange: ({ target }) => {
        const { factor } = scaleOf(sample, state);
        change({
          [name]:
            target.value === "" || !Number.isFinite(target.valueAsNumber) ? undefined : target.valueAsNumber * factor,
        });
      },
    });
  const low = end("low", "Lower end of the colour range"),
    high = end("high", "Upper end of the colour range"),
    unit = h("span", { class: "name" });
  const map = h(
    "select",
    { "data-pick": "map", "aria-label": "Colour map", onchange: ({ target }) => change({ map: target.value }) },
    colourMaps.map(([value, label]) => h("option", { value }, label)),
  );
  const log = h(
    "button",
    {
      class: "toggle",
      "data-toggle": "log",
      title: "Logarithmic colour scale",
      onclick: () => change({ log: !scaleOf(sample, state).log }),
    },
    "Log",
  );
  const usual = h(
    "button",
    {
      class: "toggle",
      "data-toggle": "usual",
      title: "Restore the default map and range",
      onclick: () => {
        const { [mode()]: _, ...scales } = state.get("scales");
        state.set({ scales });
      },
    },
    "Reset",
  );
  const row = h(
    "div",
    { class: "choice colour-range", role: "group", "aria-label": "Colours of the grains" },
    map,
    low,
    h("span", { class: "name" }, "to"),
    high,
    unit,
    log,
    usual,
  );
  const refresh = () => {
    const scale = scaleOf(sample, state);
    row.hidden = !scale;
    if (!scale) return;
    map.value = scale.map;
    low.value = shown(scale.low / scale.factor);
    high.value = shown(scale.high / scale.factor);
    unit.textContent = scale.unit;
    log.setAttribute("aria-pressed", String(scale.log));
    usual.disabled = !state.get("scales")[mode()];
  };
  state.watch(["colour", "scales"], refresh);
  refresh();
  return [picker("Grains", "colour", state, colouringsOf(sample)), row];
}

const shown = (v) => String(Number(v.toPrecision(4)));
