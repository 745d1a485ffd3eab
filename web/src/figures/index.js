import { coarseFields } from "./coarse_fields.js";
import { describedFigure } from "./described.js";
import { fitMaps } from "./film_fit.js";
import { stressMaps } from "./film_grains.js";
import { grainScatter } from "./grain_scatter.js";

/** Figures that are pictures, by their ids, with renderers of their own. A member gives: `when(texture, sample)` (is
    there anything to draw), `draw({ sample, state, texture, theme, width })` -> SVG; `key` (entries above the drawing),
    `follows` (redrawn at every snapshot, or when one of these keys of the state changes), `pickers` (keys of the state
    with their options as lists: key = [label, function of the sample that gives the options]). */
const pictures = {
  "coarse-fields": coarseFields,
  "film-fit": fitMaps,
  "film-maps": stressMaps,
  "grain-scatter": grainScatter,
};

/** The figures of a part in the order of the page, from what the program says of each. */
export const figuresOf = (heads) =>
  heads.map((head) => (pictures[head.id] ? { ...head, ...pictures[head.id] } : describedFigure(head)));
