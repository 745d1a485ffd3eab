#pragma once
#include <string>

#include "workflow/predict.hpp"

namespace arenite::app {

/// What a run will cost and be like, for people: time step, a line a stage, warnings.
std::string prediction_text(const workflow::Prediction& prediction);

/// "3.1 MB".
std::string bytes_text(double bytes);

}  // namespace arenite::app
