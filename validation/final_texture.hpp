#pragma once
#include "validation/results.hpp"
#include "workflow/final_state.hpp"

namespace arenite::validation {

using study::FinalState;
/// The last state of a run; `rev`: with the REV study. Throws InputError if the run's files are not there.
inline FinalState final_state(const Run& run, bool rev = false) { return study::final_state(run.folder(), rev); }

}  // namespace arenite::validation
