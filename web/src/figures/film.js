import { certainty, rankedForces } from "./film_forces.js";
import { rankedStresses, stressMaps } from "./film_grains.js";
import { againstTwin, stressTails } from "./film_twin.js";

/** Every figure of a film, in the order of the page; `sample` is its FilmResult and there is no texture. */
export const filmFigures = [stressMaps, againstTwin, stressTails, rankedForces, certainty, rankedStresses];
