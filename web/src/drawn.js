/** What pictures on the page and in print have in common beside the numbers that they show is one table of the
    program's (`report/drawn.hpp`), which the page's data hold: names of kinds, sizes, ends of scales. */
let table = {};

export function readDrawn(of) {
  table = of;
}

export const drawn = () => table;

/** How wide a force is drawn, in the unit of the mean radius: proportional to it up to a cap. */
export function widthOfForce(force, meanForce, meanRadius) {
  const { width, widest } = table.chain;
  return meanRadius * Math.min(widest, (width * Math.abs(force)) / (meanForce || 1));
}

/** By the library's scale of forces: strong is above the mean, tension beyond its traces. */
export const kindOfForce = (force, { mean, tension }) =>
  force < tension ? "tension" : force > mean ? "strong" : "weak";

/** A kind of nodes in words: "large grain", of several "large grains". */
export const kindWords = (kind, several = false) => table.kinds[kind][several ? "many" : "one"];

/** Ways in which bonds between grains break, as `broken` of a state counts them from 1. */
export const ways = () => table.breaks.slice(1);
