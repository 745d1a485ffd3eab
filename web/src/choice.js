import { h, plain, rich } from "./dom.js";

/** A row of buttons of which one is pressed: the value of a key of the state. Options = [[value, label]]. */
export function choice(name, key, state, options) {
  const buttons = options.map(([value, label]) =>
    h("button", { "data-value": value, onclick: () => state.set({ [key]: value }) }, rich(label)),
  );
  const refresh = () =>
    buttons.forEach((b) => b.setAttribute("aria-pressed", String(b.dataset.value === state.get(key))));
  state.watch([key], refresh);
  refresh();
  return h(
    "div",
    { class: "choice", role: "group", "aria-label": name || key, "data-choice": key },
    name && h("span", { class: "name" }, name),
    h("div", { class: "segments" }, buttons),
  );
}

/** A list of which one is chosen, for more options than a row of buttons holds. */
export function picker(name, key, state, options) {
  const select = h(
    "select",
    { "data-pick": key, "aria-label": name, onchange: ({ target }) => state.set({ [key]: target.value }) },
    options.map(([value, label]) => h("option", { value }, plain(label))),
  );
  const refresh = () => {
    select.value = state.get(key);
  };
  state.watch([key], refresh);
  refresh();
  return h("label", { class: "choice" }, h("span", { class: "name" }, name), select);
}

/** A button that switches a key of the state on and off. */
export function toggle(label, key, state, title) {
  const button = h(
    "button",
    { class: "toggle", title, "data-toggle": key, onclick: () => state.set({ [key]: !state.get(key) }) },
    rich(label),
  );
  const refresh = () => button.setAttribute("aria-pressed", String(Boolean(state.get(key))));
  state.watch([key], refresh);
  refresh();
  return button;
}
