import { h } from "../dom.js";
import { text } from "../text.js";

const pause = 450;  // ms between frames while playing

/** The slider over the stored states, with a button that plays them. */
export function timeline(sample, state) {
  const last = sample.frameCount - 1;
  if (last < 1) return h("div", { class: "timeline single" }, h("output", {}, describe(sample, sample.about.frames[last])));
  const slider = h("input", {
    type: "range", min: 0, max: last, step: 1, value: state.get("frame"), "aria-label": "State of the loading",
    oninput: (event) => state.set({ frame: Number(event.target.value), playing: false }),
  });
  const play = h("button", { class: "play", onclick: () => state.set({ playing: !state.get("playing") }) });
  const output = h("output");
  const refresh = () => {
    slider.value = state.get("frame");
    slider.style.setProperty("--done", `${(100 * state.get("frame")) / last}%`);
    output.replaceChildren(describe(sample, sample.about.frames[state.get("frame")]));
    play.textContent = state.get("playing") ? "\u275a\u275a" : "\u25b6\ufe0e";
    play.setAttribute("aria-label", state.get("playing") ? "Pause" : "Play the loading");
  };
  state.watch(["frame", "playing"], refresh);
  let timer = null;
  state.watch(["playing"], () => {
    clearInterval(timer);
    if (!state.get("playing")) return;
    if (state.get("frame") === last) state.set({ frame: 0 });
    timer = setInterval(() => {
      if (state.get("frame") === last) return state.set({ playing: false });
      state.set({ frame: state.get("frame") + 1 });
    }, pause);
  });
  refresh();
  return h("div", { class: "timeline" }, play, h("div", { class: "track" }, slider, ticks(sample)), output);
}

/** A mark under the slider where a stage ends. */
function ticks(sample) {
  const last = sample.frameCount - 1;
  const marks = sample.about.frames.flatMap((frame, k) => {
    const next = sample.about.frames[k + 1];
    return next && next.stage !== frame.stage ? [(k + 0.5) / last] : [];
  });
  return h("div", { class: "ticks" }, marks.map((at) => h("i", { style: `left:${100 * at}%` })));
}

function describe(sample, frame) {
  if (!frame) return "";
  const stage = sample.stages[frame.stage].name;
  const parts = [stage, frame.label, `t = ${text.quantity(frame.time, "s")}`].filter(Boolean);
  return parts.filter((part, k) => parts.indexOf(part) === k).join(" \u00b7 ");
}
