import { h, rich } from "../dom.js";
import { text } from "../text.js";
import { nameOfKind } from "./tooltip.js";

/** What is said of the grain that is shown close up, in a corner of the picture, with the way back. */
export function closeUp(result, state) {
  const box = h("div", { class: "close-up", hidden: true });
  const refresh = () => {
    const g = state.get("grain") - 1;
    box.hidden = g < 0;
    if (g < 0) return;
    box.replaceChildren(
      h(
        "p",
        {},
        `${nameOfKind(result.map.kindOfGrain(g))} ${g + 1}`,
        h(
          "button",
          { class: "back", title: "Show the whole sample", onclick: () => state.set({ grain: 0 }) },
          "\u2715",
        ),
      ),
      h(
        "dl",
        {},
        rows(result, g).map(([name, value]) => [h("dt", {}, rich(name)), h("dd", {}, value)]),
      ),
    );
  };
  state.watch(["grain"], refresh);
  return box;
}

function rows(result, g) {
  const list = [
    ["diameter", text.quantity(2 * result.radiusOfGrain(g), "m")],
    ["nodes", text.count(result.grains.nodes[g])],
  ];
  if (!result.loaded) return list;
  const of = (id) => result.ofGrain(id, g),
    unit = result.unitOf("yy"),
    [against, relative] = result.relative(of),
    { yy_least: least, yy_most: most } = result.grains;
  return [
    ...list,
    ["mean \u03c3_{yy}", text.quantity(of("yy"), unit)],
    [against, text.number(relative)],
    ["\u03c3_{1}, \u03c3_{2}", `${text.quantity(of("principal"), unit)}, ${text.quantity(of("second"), unit)}`],
    ["direction of \u03c3_{1}", `${Math.round(of("angle"))}\u00b0`],
    ["\u03c3_{yy} from, to", `${text.quantity(least[g], unit)}, ${text.quantity(most[g], unit)}`],
  ];
}
