#pragma once
#include "validation/results.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::validation {

using workflow::FinalState;
/// The last state of a run; `rev`: with the REV study. Throws InputError if the run's files are not there.
inline FinalState final_state(const Run& run, bool rev = false) {
  return workflow::final_state(run.folder(), {.rev = rev});
}

}  // namespace arenite::validation
