#pragma once
#include "validation/claims/paper_checks.hpp"

namespace arenite::validation {

/// The same checks for the samples that are sheared (study "paper-loads", sigma_xy), reported with the claim.
void add_shear(Judgement& judgement, const Results& results, const Asked& asked);
/// Says whether compression is tension with the sign turned, over all numbers of the runs with both.
void add_compression(Judgement& judgement, const Results& results);

}  // namespace arenite::validation
