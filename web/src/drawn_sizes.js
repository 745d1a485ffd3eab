/** Sizes that are no measure of anything, chosen so that pictures are read easily. Print draws the same
    (`python/arenite/figures/style.py`, which web/test/packing_parts.test.mjs compares), so that a picture on the page
    and the figure of the same state look alike. */

/** Width of a contact force over the radius of a mean grain: at the mean force, and at most. */
export const chain = { width: 0.16, widest: 1.1 };

/** A crack: half its length over the smaller radius, short of the rims so that cracks of neighbouring bonds do not run
    into each other; and over the sum of the radii how far apart its grains are at most: beyond it there are two pieces,
    and no crack to be seen. */
export const crack = { half: 0.9, farthest: 1.5 };

/** How wide a force is drawn, in the unit of the mean radius: proportional to it up to a cap. */
export const widthOfForce = (force, meanForce, meanRadius) =>
  meanRadius * Math.min(chain.widest, (chain.width * Math.abs(force)) / (meanForce || 1));
