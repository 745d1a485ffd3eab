#pragma once
#include "report/figures/stage_figures.hpp"

namespace arenite::report::figures {

/// Strain at the largest and the smallest load against the number of the cycle, and the loops of stress and strain.
Drawings cycles(const StageData& data);

}  // namespace arenite::report::figures
