#pragma once
#include "validation/claims/paper_checks.hpp"

namespace arenite::validation {

/// The same checks for samples that elements solve (study "paper-elements"), reported with the claim, and against bonds
/// in these very samples: a check that ends alike is of the material, one that does not is of the lattice.
void add_elements(Judgement& judgement, const Results& results, const Asked& asked);

}  // namespace arenite::validation
