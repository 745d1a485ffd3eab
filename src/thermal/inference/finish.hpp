#pragma once
#include "thermal/inference/balance.hpp"

namespace arenite::inference {

/// What both roads hand back: forces `force` (N), errors from the inverse of `equations`.
InferredForces finish(const ForceProblem& problem, const ForceOptions& options, const NormalEquations& equations, const Unknowns& unknowns,
                      const std::vector<std::vector<Touch>>& touches, const std::vector<double>& force);

}  // namespace arenite::inference
