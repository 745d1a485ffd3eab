import { h } from "../dom.js";
import { draw, keyOf } from "../figures/described.js";
import { fieldFigure } from "./field.js";
import { sampleFigure } from "./sample.js";

/** A figure of a study as a card shows it: what the program describes, or the picture of a run; where nothing of it is
    there, the sentence that says why. */
export function studyFigure(figure) {
  const { sample, drawing, missing } = figure;
  const caption = [figure.caption, drawing?.note, (sample || drawing) && missing].filter(Boolean).join(" ");
  if (sample) return { ...(sample.nodes ? fieldFigure(figure) : sampleFigure(figure)), caption };
  if (!drawing) return { ...figure, caption, draw: () => missing && h("p", { class: "nothing" }, missing) };
  return {
    ...figure,
    caption,
    key: ({ theme }) => keyOf(drawing, null, theme),
    draw: (about) => draw(drawing, { ...about, here: null }),
  };
}
