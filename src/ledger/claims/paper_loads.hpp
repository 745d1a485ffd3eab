#pragma once
#include <functional>

#include "ledger/claims/paper_runs.hpp"

namespace arenite::ledger {

/// Judges the sharpened checks of a claim by the samples that are sheared (study "paper-loads", sigma_xy) and says in a
/// finding which of them hold.
void add_shear(Judgement& judgement, const Results& results, const std::function<Verdict(const Samples&)>& sharpened);
/// Says whether compression is tension with the sign turned, over all numbers of the runs with both.
void add_compression(Judgement& judgement, const Results& results);

}  // namespace arenite::ledger
