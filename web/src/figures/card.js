import { h, rich, s } from "../dom.js";
import { choice } from "../choice.js";
import { fileName, savePng, saveSvg, svgText } from "../save.js";
import { themeOf } from "../theme.js";
import { text } from "../text.js";

/** A figure in its frame: title, key, drawing, caption and the buttons that save it. It follows the slider, the theme
    and the room it has. */
export function figureCard(figure, sample, state) {
  const drawing = h("div", { class: "drawing" }), keys = h("div", { class: "keys" });
  const name = () => fileName(sample.title, sample.resultName ?? "", figure.id);
  const theme = () => themeOf(state.get("theme"));
  const picture = () => drawing.querySelector("svg");
  const asPng = () => {
    const { width, height } = picture().viewBox.baseVal;
    return savePng(name(), svgText(picture(), theme()), width, height, 3);
  };
  const card = h("figure", { class: `card figure${figure.wide ? " wide" : ""}`, "data-figure": figure.id },
    h("figcaption", { class: "title" }, h("h3", {}, rich(figure.title)),
      h("span", { class: "saves" },
        Object.entries(figure.choices ?? {}).map(([key, [label, options]]) => choice(label, key, state, options)),
        h("button", { class: "save", "data-save": "svg", title: "Save this figure as SVG", onclick: () => saveSvg(name(), picture(), theme()) }, "SVG"),
        h("button", { class: "save", "data-save": "png", title: "Save this figure as PNG", onclick: asPng }, "PNG"))),
    keys, drawing, h("p", { class: "caption" }, rich(figure.caption)));
  const follows = figure.follows === true ? ["frame"] : figure.follows ?? [];
  let drawn = "";
  const draw = (force) => {
    const width = Math.floor(drawing.clientWidth);
    if (width < 50) return;
    const texture = sample.texture(state.get("frame"));
    const about = { sample, state, texture, theme: theme(), width };
    const what = [width, state.get("theme"), texture?.frame, ...follows.map((key) => state.get(key))].join(" ");
    if (what === drawn && !force) return;
    drawn = what;
    const there = !texture || figure.when(texture, sample);
    keys.replaceChildren(...(there && figure.key ? figure.key(about).map(entry) : []));
    const before = drawing.clientHeight;
    drawing.replaceChildren((there && figure.draw(about)) || h("p", { class: "nothing" }, "Nothing of this kind in this state."));
    drawing.style.minHeight = picture() ? "" : `${before}px`;  // the page does not jump while the slider passes by
    card.querySelectorAll(".save").forEach((button) => { button.disabled = !picture(); });
  };
  new ResizeObserver(() => draw(false)).observe(drawing);
  state.watch(["theme", "frame", ...follows], () => draw(false));
  return card;
}

/** The key's symbols: strokes within 18 by 8. */
const strokes = { times: "M6,1l6,6M6,7l6,-6", plus: "M9,0v8M5,4h8", diamond: "M9,1.5l2,2.5l-2,2.5l-2,-2.5Z" };

function entry({ name, colour, values, dash = null, symbol = null }) {
  const numbers = values.map(([symbol, estimate]) => {
    const { value, error } = text.withError(estimate.value, estimate.error);
    return [" ", h("span", { class: "estimate" }, rich(symbol), ` ${value}`, error && h("small", {}, ` \u00b1 ${error}`))];
  });
  const line = s("svg", { width: 18, height: 8, viewBox: "0 0 18 8" }, symbol ? s("path", { d: strokes[symbol], fill: "none", stroke: colour, "stroke-width": 1.6 }) : s("line", { x1: 1, x2: 17, y1: 4, y2: 4, stroke: colour, "stroke-width": 2.5, "stroke-dasharray": dash, "stroke-linecap": dash ? null : "round" }));
  return h("span", { class: "entry" }, line, h("b", {}, rich(name)), numbers);
}
