#pragma once
#include "ledger/results.hpp"
#include "study/final_state.hpp"

namespace arenite::ledger {

using study::FinalState;
/// The last state of a run; `rev`: with the REV study. Throws InputError if the run's files are not there.
inline FinalState final_state(const Run& run, bool rev = false) { return study::final_state(run.folder(), rev); }

/// How often two samples of one law would differ as much in their cumulative shares (Kolmogorov and Smirnov); NaN where one
/// is empty.
double chance_of_one_law(std::vector<double> a, std::vector<double> b);

}  // namespace arenite::ledger
