#pragma once
#include "thermal/inference/contact_forces.hpp"

namespace arenite::inference {

/// Throws InputError with everything that is wrong with grains, contacts, walls and options; `factors` where those
/// count.
void check_problem(const ForceProblem& problem, const ForceOptions& options, bool factors);

}  // namespace arenite::inference
