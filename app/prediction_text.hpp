#pragma once
#include <string>

#include "statistics/numbers.hpp"
#include "workflow/predict.hpp"

namespace arenite::app {

/// What a run will cost and be like, for people: time step, a line a stage, warnings.
std::string prediction_text(const workflow::Prediction& prediction);

/// The same for programs; units in the names.
Numbers prediction_numbers(const workflow::Prediction& prediction);

}  // namespace arenite::app
