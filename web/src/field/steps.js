import { h } from "../dom.js";
import { text } from "../text.js";
import { brokenAt } from "./cracks.js";

const duration = 6000,
  least = 40; // ms: of the whole play, between two steps

/** The slider over the steps of a test to failure, with a button that plays them. */
export function stepSlider(result, state) {
  const last = result.steps - 1;
  const slider = h("input", {
    type: "range",
    min: 0,
    max: last,
    step: 1,
    "aria-label": "Step of the test",
    oninput: (event) => state.set({ step: Number(event.target.value), playing: false, cracks: true }),
  });
  const play = h("button", {
    class: "play",
    onclick: () => state.set({ playing: !state.get("playing"), cracks: true }),
  });
  const output = h("output");
  const refresh = () => {
    const step = state.get("step");
    slider.value = step;
    slider.style.setProperty("--done", `${(100 * step) / last}%`);
    output.textContent = describe(result, step);
    play.textContent = state.get("playing") ? "\u275a\u275a" : "\u25b6\ufe0e";
    play.setAttribute("aria-label", state.get("playing") ? "Pause" : "Play the test");
  };
  state.watch(["step", "playing"], refresh);
  let timer = null;
  state.watch(["playing"], () => {
    clearInterval(timer);
    if (!state.get("playing")) return;
    if (state.get("step") === last) state.set({ step: 0 });
    const stride = Math.max(1, Math.ceil((last * least) / duration));
    timer = setInterval(
      () => {
        if (state.get("step") === last) return state.set({ playing: false });
        state.set({ step: Math.min(last, state.get("step") + stride) });
      },
      Math.max(least, Math.min(400, duration / last)),
    );
  });
  refresh();
  return h("div", { class: "timeline" }, play, h("div", { class: "track" }, slider), output);
}

function describe(result, step) {
  const { strain, stress } = result.curve;
  return [
    `step ${step + 1} of ${result.steps}`,
    `strain ${text.number(strain[step], 3)}`,
    `stress ${text.quantity(stress[step], stress.unit)}`,
    `${text.count(brokenAt(result, step))} bonds broken`,
  ].join(" \u00b7 ");
}
