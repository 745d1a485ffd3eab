import { h, plain, rich, s } from "../dom.js";
import { choice, picker } from "../choice.js";
import { fileName, savePng, saveSvg, saveText, svgText } from "../save.js";
import { themeOf } from "../theme.js";
import { csvOf, rowsOf } from "./csv.js";

/** A figure in its frame: title, key, drawing, caption and the buttons that save it. It follows the slider, the theme
    and the room it has. */
export function figureCard(figure, sample, state) {
  const drawing = h("div", { class: "drawing" }),
    keys = h("div", { class: "keys" });
  const name = () => fileName(sample.title, sample.resultName ?? "", figure.id);
  const theme = () => themeOf(state.get("theme"));
  const picture = () => drawing.querySelector("svg");
  const asPng = () => {
    const { width, height } = picture().viewBox.baseVal;
    return savePng(name(), svgText(picture(), theme()), width, height, 3);
  };
  const saveButton = (form, onclick) =>
    h(
      "button",
      {
        class: "save",
        "data-save": form,
        title: `Save this figure as ${form.toUpperCase()}`,
        "aria-label": `Save \u201c${plain(figure.title)}\u201d as ${form.toUpperCase()}`,
        onclick,
      },
      form.toUpperCase(),
    );
  const card = h(
    "figure",
    { class: `card figure${figure.wide ? " wide" : ""}`, "data-figure": figure.id, "aria-label": plain(figure.title) },
    h(
      "figcaption",
      { class: "title" },
      h("h3", {}, rich(figure.title)),
      h(
        "span",
        { class: "saves" },
        Object.entries(figure.choices ?? {}).map(([key, [label, options]]) => choice(label, key, state, options)),
        Object.entries(figure.pickers ?? {}).map(([key, [label, optionsOf]]) =>
          picker(label, key, state, optionsOf(sample)),
        ),
        saveButton("svg", () => saveSvg(name(), picture(), theme())),
        saveButton("png", asPng),
        saveButton("csv", () => saveText(`${name()}.csv`, "text/csv", csvOf(picture()))),
      ),
    ),
    keys,
    drawing,
    h("p", { class: "caption" }, rich(figure.caption)),
  );
  const follows = figure.follows === true ? ["snapshot"] : (figure.follows ?? []);
  let drawn = "";
  const draw = (force) => {
    const width = Math.floor(drawing.clientWidth);
    if (width < 50) return;
    const texture = sample.texture(state.get("snapshot"));
    const about = { sample, state, texture, theme: theme(), width };
    const what = [width, state.get("theme"), texture?.snapshot, ...follows.map((key) => state.get(key))].join(" ");
    if (what === drawn && !force) return;
    drawn = what;
    const there = !texture || figure.when(texture, sample);
    keys.replaceChildren(...(there && figure.key ? figure.key(about).map(entry) : []));
    const before = drawing.clientHeight;
    drawing.replaceChildren(
      (there && figure.draw(about)) || h("p", { class: "nothing" }, "No data for this figure in this state."),
    );
    label(picture(), figure);
    drawing.style.minHeight = picture() ? "" : `${before}px`; // the page does not jump while the slider passes by
    card.querySelectorAll(".save").forEach((button) => {
      button.disabled = !picture() || (button.dataset.save === "csv" && !rowsOf(picture()).length);
    });
  };
  new ResizeObserver(() => draw(false)).observe(drawing);
  state.watch(["theme", "snapshot", ...follows], () => draw(false));
  return card;
}

/** What is drawn, in words for who does not see it. */
function label(svg, { title, caption }) {
  svg?.setAttribute("role", "img");
  svg?.setAttribute("aria-label", `${plain(title)}: ${plain(caption)}`);
}

/** The key's symbols: strokes within 18 by 8. */
const strokes = { times: "M6,1l6,6M6,7l6,-6", plus: "M9,0v8M5,4h8", diamond: "M9,1.5l2,2.5l-2,2.5l-2,-2.5Z" };

function entry({ name, colour, numbers = [], dash = null, symbol = null }) {
  const said = numbers.map(([of, value, error]) => [
    " ",
    h("span", { class: "estimate" }, rich(of), ` ${value}`, error && h("small", {}, ` \u00b1 ${error}`)),
  ]);
  const line = s(
    "svg",
    { width: 18, height: 8, viewBox: "0 0 18 8" },
    symbol
      ? s("path", { d: strokes[symbol], fill: "none", stroke: colour, "stroke-width": 1.6 })
      : s("line", {
          x1: 1,
          x2: 17,
          y1: 4,
          y2: 4,
          stroke: colour,
          "stroke-width": 2.5,
          "stroke-dasharray": dash,
          "stroke-linecap": dash ? null : "round",
        }),
  );
  return h("span", { class: "entry" }, line, h("b", {}, rich(name)), said);
}
