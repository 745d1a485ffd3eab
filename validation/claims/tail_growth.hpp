#pragma once
#include <string>

#include "validation/claims/paper_runs.hpp"

namespace arenite::validation {

/// Slope of the tail's slope s against gamma at the highest S_m that all samples reach, less that at the lowest (theta
/// 1.4, grains of a class): whether gamma's effect on s grows with S_m. At one width of the bridges S_m differs with
/// gamma, so samples are compared at equal S_m, between whose widths s is interpolated.
Value growth_of_effect(const Samples& samples, const std::string& set);

}  // namespace arenite::validation
