#pragma once
#include "validation/claim.hpp"
#include "validation/results.hpp"

namespace arenite::validation {

// One function a claim; each says what it judges by in its file.
Judgement judge_t1(const Results& results);
Judgement judge_t2(const Results& results);
Judgement judge_t3(const Results& results);
Judgement judge_t4(const Results& results);
Judgement judge_t5(const Results& results);
Judgement judge_t6(const Results& results);
Judgement judge_t7(const Results& results);
Judgement judge_t8(const Results& results);
Judgement judge_t9(const Results& results);
Judgement judge_t10(const Results& results);
Judgement judge_t11(const Results& results);
Judgement judge_t12(const Results& results);
Judgement judge_t13(const Results& results);
Judgement judge_t14(const Results& results);
Judgement judge_t15(const Results& results);
Judgement judge_t16(const Results& results);
Judgement judge_t17(const Results& results);
Judgement judge_t18(const Results& results);
Judgement judge_t19(const Results& results);
Judgement judge_t20(const Results& results);
Judgement judge_t21(const Results& results);
Judgement judge_t22(const Results& results);

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

}  // namespace arenite::validation
