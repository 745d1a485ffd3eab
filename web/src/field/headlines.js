import { headlines, tilesOf } from "../numbers.js";

const sample = [
  ["grains", "\u03c1_{p}", "phases.particle", "%"],
  ["matrix in the pores", "S_{m}", "S_m", "%"],
  ["void", "\u03c1_{v}", "phases.void", "%"],
];
const modulus = ["apparent modulus", "E", "modulus_Pa"];
const failure = [
  modulus,
  ["strength", "", "strength_Pa"],
  ["strain at peak stress", "", "failure.strain_at_strength", "\u2030"],
];
const meanOf = (set) => [
  `in ${set} grains`.replace("particle ", ""),
  "\u27e8\u03c3_{yy}\u27e9/\u27e8\u03c3_{yy}\u27e9_{all}",
  `stress.sigma_yy.sets.${set}.mean_over_sample_mean`,
];
const response = [
  modulus,
  ["mean stress", "\u27e8\u03c3_{yy}\u27e9", "stress.sigma_yy.sample_mean_Pa"],
  meanOf("large"),
  meanOf("small"),
  meanOf("particle"),
];

/** The numbers that one asks for first: of the sample always, of its response where it was loaded. */
export function fieldHeadlines({ declared, steps, loaded }) {
  const first = (rows) =>
    tilesOf(declared, rows)
      .filter(({ known }) => known)
      .slice(0, 3);
  return headlines([...first(sample), ...(steps > 1 ? first(failure) : loaded ? first(response) : [])]);
}
