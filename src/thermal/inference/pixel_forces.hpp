#pragma once
#include "thermal/inference/contact_forces.hpp"

namespace arenite::inference {

/// Forces from pixels: least squares of every pixel's warming (superposed Flamant fields with the term that frees the
/// rim, seen through lens and pixel) with the balance of every grain, wall loads and, weakly, the smallest elastic
/// energy; centres are refined with the forces. Standard errors hold the errors of pixels, fields and centres; they
/// know of no cone. Throws InputError where a factor is missing, grains overlap by more than a fifth of the smaller
/// diameter, or no pixel sees a contact.
InferredForces infer_from_pixels(const ForceProblem& problem, const ThermoelasticPicture& picture,
                                 const ForceOptions& options);

}  // namespace arenite::inference
