#pragma once
#include <string>

#include "model/lockin_maps.hpp"
#include "statistics/numbers.hpp"
#include "thermal/thermography/step/step_load.hpp"

namespace arenite::workflow {

/// What the maps of a lock-in tell of themselves, as commands, films and page have it: frequency with its error, frames
/// that were used and lost, phase of the load, whether the film shows a load, and errors that pixels share; `unit` is
/// that of the film.
Numbers lockin_numbers(const LockinMaps& maps, const std::string& unit);

/// The same of the maps of a step.
Numbers step_numbers(const thermography::StepMaps& maps);

}  // namespace arenite::workflow
