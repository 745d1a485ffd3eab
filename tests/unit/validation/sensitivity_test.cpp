#include "validation/sensitivity.hpp"

#include <gtest/gtest.h>

#include "unit/validation/made_up_table.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/pooled.hpp"

namespace arenite::validation {
namespace {

const std::vector<Choice> two_choices{{{{"friction", "0"}}, "without friction"}, {{{"drag", "1"}}, "with drag"}};

/// 1 as it is, 3 without friction, not known with drag.
Value value_under(const Choice& choice) {
  if (choice.where.front().first == "drag") return {};
  return {choice.where.front().second == "0" ? 3.0 : 1.0, 0.1, 4};
}

TEST(Sensitivity, TellsWhichChoiceGivesWhatIsWanted) {
  Judgement judgement;
  add_sensitivity(judgement, "z", {{{"friction", "0.3"}}, ""}, two_choices, value_under, wanted_above(2));
  ASSERT_EQ(judgement.sensitivities.size(), 1u);
  const Sensitivity& z = judgement.sensitivities.front();
  EXPECT_EQ(z.wanted, "> 2");
  EXPECT_EQ(z.range.low, 2);
  ASSERT_EQ(z.entries.size(), 3u);
  EXPECT_EQ(z.entries[0].value.value, 1);
  EXPECT_EQ(z.entries[0].outcome, Outcome::fails);
  EXPECT_EQ(z.entries[1].choice, "without friction");
  EXPECT_EQ(z.entries[1].value.error, 0.1);
  EXPECT_EQ(z.entries[1].outcome, Outcome::holds);
  EXPECT_EQ(z.entries[2].outcome, Outcome::unknown);
}

TEST(Sensitivity, IsNotToldWithoutTheUsualRuns) {
  Judgement judgement;
  add_sensitivity(judgement, "z", {{{"drag", "0"}}, ""}, two_choices, value_under, {});
  EXPECT_TRUE(judgement.sensitivities.empty());
}

TEST(Sensitivity, WantedTellsBothSides) {
  const auto outcome = [](const Wanted& wanted, double value, double error) {
    return wanted({value, error, 4}).outcome;
  };
  EXPECT_EQ(outcome(wanted_below(2), 1, 0.1), Outcome::holds);
  EXPECT_EQ(outcome(wanted_below(2), 3, 0.1), Outcome::fails);
  EXPECT_EQ(outcome(wanted_within(2, 0.5), 2.1, 0.1), Outcome::holds);
  EXPECT_EQ(outcome(wanted_within(2, 0.5), 1.1, 0.1), Outcome::fails);
  EXPECT_EQ(outcome(wanted_positive(), 1, 0.3), Outcome::holds);
  EXPECT_EQ(outcome(wanted_positive(), 1, 0.6), Outcome::undecided);
  EXPECT_EQ(outcome(wanted_negative(), -1, 0.3), Outcome::holds);
  EXPECT_EQ(outcome(wanted_equivalent(1), 0.1, 0.1), Outcome::holds);
  EXPECT_EQ(outcome(wanted_equivalent(1), 0.1, 0.6), Outcome::undecided);
  EXPECT_EQ(wanted_within(2, 0.5)({}).wanted, "1.5 to 2.5");
}

TEST(Sensitivity, OfTheStiffnessRatioIsWorkedOutFromTheRunsOfItsStudy) {
  const auto table = [](double factor) {
    std::vector<MadeUpRun> runs;
    for (const char* stiffness : {"27.35", "6.8375", "2.735"})
      for (const char* seed : {"1", "2"})
        runs.push_back({{stiffness, "0.1", seed},
                        {factor * 27.35 / std::stod(stiffness) * std::stod(seed) + 100 * std::stod(seed)}});
    return made_up_table({"materials.B.stiffness", "contact.friction", "seed"}, {"z"}, runs);
  };
  Results results;
  results.add("thesis-ch5", table(1));
  results.add("thesis-ch5-r", table(2));
  results.add("thesis-choices-stiffness", table(3));
  Judgement judgement;
  const auto slope = [](const std::vector<validation::Run>& runs, const Number& number) {
    return slope_over_seeds(runs, stiffness_ratio, number);
  };
  add_stiffness_change(judgement, results, "z", slope, "z", wanted_equivalent(1));
  ASSERT_EQ(judgement.sensitivities.size(), 1u);
  const auto of = [&](const std::string& choice) {
    for (const auto& entry : judgement.sensitivities[0].entries)
      if (entry.choice == choice) return entry.value;
    return Value();
  };
  EXPECT_NEAR(of("").value, 1.5, 1e-12);
  EXPECT_NEAR(of("").error, 0.5, 1e-12);
  EXPECT_NEAR(of("with law R").value, 3, 1e-12);
  EXPECT_NEAR(of("with friction 0.1").value, 4.5, 1e-12);
  EXPECT_TRUE(std::isnan(of("without friction").value)) << "there are no such runs";
}

}  // namespace
}  // namespace arenite::validation
