import { course } from "./course.js";
import { forceDistribution, stressDistribution } from "./distributions.js";
import { approach, energies, travel, wallForces } from "./history.js";
import { roses } from "./roses.js";
import { contactNumbers, coordination, rev, threshold } from "./structure.js";

/** Every figure of the page, in the order of the page. A member gives: id, title, caption, `when(texture, sample)` (is
    there anything to draw), `draw({ sample, state, texture, theme, width })` -> SVG; `key` (entries above the drawing),
    `wide` (takes a whole row), `follows` (redrawn at every frame). A new figure is one more row. */
export const figures = [roses, stressDistribution, forceDistribution, coordination, contactNumbers, rev, threshold, course, wallForces, travel, energies, approach];
