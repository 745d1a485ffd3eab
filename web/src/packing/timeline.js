import { h } from "../dom.js";
import { text } from "../text.js";

const pause = 450; // ms between snapshots while playing

/** The slider over the stored states, with a button that plays them. */
export function timeline(sample, state) {
  const last = sample.snapshotCount - 1;
  if (last < 1)
    return h("div", { class: "timeline single" }, h("output", {}, describe(sample, sample.about.snapshots[last])));
  const slider = h("input", {
    type: "range",
    min: 0,
    max: last,
    step: 1,
    value: state.get("snapshot"),
    "aria-label": "State of the loading",
    oninput: (event) => state.set({ snapshot: Number(event.target.value), playing: false }),
  });
  const play = h("button", { class: "play", onclick: () => state.set({ playing: !state.get("playing") }) });
  const output = h("output");
  const refresh = () => {
    slider.value = state.get("snapshot");
    slider.style.setProperty("--done", `${(100 * state.get("snapshot")) / last}%`);
    output.replaceChildren(describe(sample, sample.about.snapshots[state.get("snapshot")]));
    play.textContent = state.get("playing") ? "\u275a\u275a" : "\u25b6\ufe0e";
    play.setAttribute("aria-label", state.get("playing") ? "Pause" : "Play the loading");
  };
  state.watch(["snapshot", "playing"], refresh);
  let timer = null;
  state.watch(["playing"], () => {
    clearInterval(timer);
    if (!state.get("playing")) return;
    if (state.get("snapshot") === last) state.set({ snapshot: 0 });
    timer = setInterval(() => {
      if (state.get("snapshot") === last) return state.set({ playing: false });
      state.set({ snapshot: state.get("snapshot") + 1 });
    }, pause);
  });
  refresh();
  return h("div", { class: "timeline" }, play, h("div", { class: "track" }, slider, ticks(sample)), output);
}

/** A mark under the slider where a stage ends. */
function ticks(sample) {
  const last = sample.snapshotCount - 1;
  const marks = sample.about.snapshots.flatMap((snapshot, k) => {
    const next = sample.about.snapshots[k + 1];
    return next && next.stage !== snapshot.stage ? [(k + 0.5) / last] : [];
  });
  return h(
    "div",
    { class: "ticks" },
    marks.map((at) => h("i", { style: `left:${100 * at}%` })),
  );
}

function describe(sample, snapshot) {
  if (!snapshot) return "";
  const stage = sample.stages[snapshot.stage].name;
  const parts = [stage, snapshot.label, `t = ${text.quantity(snapshot.time, "s")}`].filter(Boolean);
  return parts.filter((part, k) => parts.indexOf(part) === k).join(" \u00b7 ");
}
