#pragma once
#include "ledger/claim.hpp"
#include "ledger/results.hpp"

namespace arenite::ledger {

// One function a claim; each says what it judges by in its file.
Judgement judge_t8(const Results& results);

Judgement judge_p1(const Results& results);
Judgement judge_p2(const Results& results);
Judgement judge_p3(const Results& results);
Judgement judge_p4(const Results& results);
Judgement judge_p5(const Results& results);
Judgement judge_p6(const Results& results);
Judgement judge_p7(const Results& results);
Judgement judge_p8(const Results& results);
Judgement judge_p9(const Results& results);
Judgement judge_p10(const Results& results);
Judgement judge_p11(const Results& results);
Judgement judge_p12(const Results& results);

}  // namespace arenite::ledger
