#pragma once
#include "report/figures/drawing.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report::figures {

/// Contact orientations over half of the sphere, of all contacts and of the strong and weak ones.
Drawings orientations_in_space(const Numbers& texture);

}  // namespace arenite::report::figures
