import { convergence } from "./convergence.js";
import { cavityVolumes } from "./cavity_volumes.js";
import { stressDensities } from "./densities.js";
import { forceDistribution, stressDistribution } from "./distributions.js";
import { brokenBonds, energyBalance, stressStrain } from "./failure.js";
import { filmOrientations } from "./film_orientations.js";
import { fitMaps } from "./film_fit.js";
import { certainty, rankedForces } from "./film_forces.js";
import { rankedStresses, stressMaps } from "./film_grains.js";
import { againstSimulation, stressTails } from "./film_simulation.js";
import { coarseFields } from "./coarse_fields.js";
import { sizeCurve } from "./size_curve.js";
import { grainScatter } from "./grain_scatter.js";
import { grainBonds } from "./grain_bonds.js";
import { approach, energies, forceDisplacement, wallForces } from "./history.js";
import { roses } from "./roses.js";
import { contactNumbers, coordination, rev, threshold } from "./structure.js";
import { discharge, testCurves } from "./test_curves.js";
import { stressPath } from "./stress_path.js";

/** Every figure of a packing, in the order of the page. A member gives: id, title, caption, `when(texture, sample)` (is
    there anything to draw), `draw({ sample, state, texture, theme, width })` -> SVG; `key` (entries above the drawing),
    `wide` (takes a whole row), `follows` (redrawn at every snapshot, or when one of these keys of the state changes), `choices`
    (keys of the state with their options, beside the title), `pickers` (the same as lists: key = [label, function of the sample that gives the
    options]). A new figure is one more row. */
export const figures = [
  testCurves,
  grainBonds,
  discharge,
  roses,
  stressDistribution,
  forceDistribution,
  grainScatter,
  sizeCurve,
  coarseFields,
  coordination,
  contactNumbers,
  rev,
  threshold,
  stressPath,
  wallForces,
  forceDisplacement,
  energies,
  approach,
];

/** Every figure of a cemented sample or its field, likewise; `sample` is its FieldResult and there is no texture. */
export const fieldFigures = [stressStrain, brokenBonds, energyBalance, stressDensities, cavityVolumes, convergence];

/** Every figure of a film, likewise; `sample` is its FilmResult. */
export const filmFigures = [
  stressMaps,
  againstSimulation,
  stressTails,
  filmOrientations,
  fitMaps,
  rankedForces,
  certainty,
  rankedStresses,
];
