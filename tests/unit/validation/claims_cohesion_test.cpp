// T22 with made-up tables: cohesion that leaves a trace and cohesion that does not, in packings that differ by far
// more.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/validation/made_up_table.hpp"
#include "validation/claims/claims.hpp"

namespace arenite::validation {
namespace {

const std::vector<std::string> numbers{"sigma_norm.by_material.glued.mean_Pa",
                                       "sigma_norm.by_material.dry.mean_Pa",
                                       "sigma_norm.by_material.glued.P0",
                                       "force.by_type.glued-glued.count",
                                       "sigma_norm.by_material.glued.count",
                                       "force.by_type.glued-glued.strong_share",
                                       "force.by_type.glued-glued.mean_N",
                                       "force.mean_N",
                                       "coordination.all",
                                       "force.strong_share"};

/// `effect` of a surface energy in kN/mm on the stress inside, a part of it; seeds differ by a tenth, and by `scatter`
/// from glue to glue.
Results made_up(double (*effect)(double gamma), double scatter = 0.004) {
  std::vector<MadeUpRun> runs;
  for (const char* gamma : {"1.060", "0.5", "0.2735", "0.000001"})
    for (int seed = 1; seed <= 8; ++seed) {
      const double packing = 1 + 0.1 * std::sin(7.0 * seed), chance = scatter * noise({1.0 * seed, std::stod(gamma)});
      const double inside = packing * (1 + effect(std::stod(gamma)) + chance);
      runs.push_back({{gamma, std::to_string(seed)},
                      {inside, packing, 0.5 * (1 + chance), 160 * packing, 77, 0.4, 100 * packing, 110 * packing,
                       4 * packing, 0.4}});
    }
  Results results;
  results.add("thesis-ch6", made_up_table({"contact.surface_energy", "seed"}, numbers, runs));
  return results;
}

const Check& control(const Judgement& judgement) { return judgement.checks[2]; }

TEST(Cohesion, ThatLeavesNoTraceIsEqualWithinTheMarginAndSoIsTheControl) {
  const Judgement none = judge_t22(made_up([](double) { return 0.0; }));
  EXPECT_EQ(none.verdict(), Verdict::reproduced);
  EXPECT_EQ(control(none).outcome, Outcome::fails) << "no trace is to be seen where there is none";
}

TEST(Cohesion, ThatLeavesATraceWhereItIsStrongIsSeenInTheControl) {
  const Judgement strong = judge_t22(made_up([](double gamma) { return gamma > 1 ? -0.06 : 0.0; }));
  EXPECT_EQ(control(strong).outcome, Outcome::holds) << control(strong).what;
  EXPECT_NE(control(strong).what.find("mean stress inside over outside"), std::string::npos) << control(strong).what;
  EXPECT_EQ(strong.verdict(), Verdict::reproduced);
}

TEST(Cohesion, ThatLeavesATraceWhereItIsWeakRefutesTheClaim) {
  const Judgement weak = judge_t22(made_up([](double gamma) { return gamma > 0.1 ? -0.12 : 0.0; }));
  EXPECT_EQ(weak.verdict(), Verdict::not_reproduced);
}

TEST(Cohesion, IsUndecidedWhereSamplesScatterBeyondTheMargin) {
  const Judgement noisy = judge_t22(made_up([](double) { return 0.0; }, 0.2));
  EXPECT_EQ(noisy.verdict(), Verdict::undecided) << "what is not significant is not equal";
  EXPECT_EQ(control(noisy).outcome, Outcome::undecided);
}

}  // namespace
}  // namespace arenite::validation
