#pragma once
#include "ledger/claim.hpp"
#include "ledger/results.hpp"

namespace arenite::ledger {

// One function a claim; each says what it judges by in its file.
Judgement judge_t8(const Results& results);

}  // namespace arenite::ledger
