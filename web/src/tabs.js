import { h } from "./dom.js";

/** Parts of the page of which one is seen: parts = [{ name, title, make() -> { element } }]. Each is made when it is
    first asked for. A single part has no row of tabs. Gives the elements, and by name what was made. */
export function tabs(parts, state) {
  const made = new Map(),
    holder = h("div");
  const buttons = parts.map(({ name, title }) =>
    h("button", { role: "tab", "data-tab": name, onclick: () => state.set({ tab: name }) }, title),
  );
  const refresh = () => {
    const now = state.get("tab");
    buttons.forEach((b) => b.setAttribute("aria-selected", String(b.dataset.tab === now)));
    if (!made.has(now)) {
      made.set(now, parts.find(({ name }) => name === now).make());
      holder.append(made.get(now).element);
    }
    for (const [name, { element }] of made) element.hidden = name !== now;
  };
  state.watch(["tab"], refresh);
  refresh();
  return {
    elements: [
      ...(parts.length > 1 ? [h("div", { class: "tabs", role: "tablist", "aria-label": "Results" }, buttons)] : []),
      holder,
    ],
    made,
  };
}
