#pragma once
#include <string>
#include <vector>

#include "report/study_figures.hpp"

namespace arenite::report {

/// What a figure's bars, bands or ticks are and over how many samples, as a sentence: "Bars: standard error over 5 samples"; what
/// is of one sample is said to be. Empty where there is nothing to say.
std::string spread_text(const Figure& figure, const std::vector<FigureCurve>& curves);

}  // namespace arenite::report
