import { h } from "../dom.js";

/** A slider over the whole numbers of a key of the state, with its value in words, which may be others in another
    snapshot. */
export function slider(name, words, key, state, [least, most], write, kind = "choice threshold") {
  const output = h("output");
  const input = h("input", {
    type: "range",
    min: least,
    max: most,
    step: 1,
    "data-slider": key,
    "aria-label": words,
    oninput: (event) => state.set({ [key]: Number(event.target.value) }),
  });
  const refresh = () => {
    const value = state.get(key);
    input.value = value;
    input.style.setProperty("--done", `${(100 * (value - least)) / Math.max(1, most - least)}%`);
    output.textContent = write(value);
  };
  state.watch([key, "snapshot"], refresh);
  refresh();
  return h(
    "div",
    { class: kind, title: words },
    h("span", { class: "name" }, h("i", {}, name)),
    h("div", { class: "track" }, input),
    output,
  );
}
