#pragma once
#include <vector>

#include "thermal/inference/contact_forces.hpp"

namespace arenite::inference {

/// Forces from the mean stresses of grains alone: sum of fn = 2 pi R L p (p = -sigma_hyd, Pa), with balance and wall
/// loads. `sigma_hyd` and its standard `error`, one a grain; a grain without a positive error says nothing. Where that
/// leaves forces undetermined (`null_space`), they are those of the smallest elastic energy.
InferredForces infer_from_means(const ForceProblem& problem, const std::vector<double>& sigma_hyd,
                                const std::vector<double>& error, const ForceOptions& options);

}  // namespace arenite::inference
