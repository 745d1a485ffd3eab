#include "validation/claims/paper_choices.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/validation/made_up_table.hpp"

namespace arenite::validation {
namespace {

const std::vector<std::string> choice_keys{"bidisperse.size_ratio", "bidisperse.volume_ratio", "cement.kind",
                                           "contact.friction", "seed"};

/// z is gamma, and -gamma without friction; the usual runs have a gamma more than the choices.
Results made_up() {
  std::vector<MadeUpRun> usual, chosen;
  for (const char* seed : {"1", "2", "3"}) {
    for (const char* gamma : {"1", "2", "5"})
      usual.push_back({{gamma, "1.4", "full", "", seed}, {std::stod(gamma) + 0.01 * std::stod(seed)}});
    for (const char* gamma : {"1", "2"})
      chosen.push_back({{gamma, "1.4", "full", "0", seed}, {-std::stod(gamma) + 0.01 * std::stod(seed)}});
  }
  chosen.resize(4);
  Results results;
  results.add("paper", made_up_table(choice_keys, {"z"}, usual));
  results.add("paper-choices", made_up_table(choice_keys, {"z"}, chosen));
  return results;
}

Value greatest(const Samples& samples) {
  Value value;
  for (const PairMean& m : pair_means(samples, "z"))
    if (!(m.value.value <= value.value)) value = m.value;
  return value;
}

TEST(PaperChoices, AreSetAgainstTheUsualRunsAtTheSamePairs) {
  Judgement j;
  add_choices(j, made_up(), "z", greatest, wanted_above(0));
  ASSERT_EQ(j.sensitivities.size(), 1u);
  const Sensitivity& found = j.sensitivities.front();
  EXPECT_NEAR(found.entries[0].value.value, 2.02, 1e-12);
  EXPECT_EQ(found.entries[0].outcome, Outcome::holds);
  EXPECT_EQ(found.entries[1].choice, "without friction");
  EXPECT_NEAR(found.entries[1].value.value, -0.985, 1e-12);
  EXPECT_EQ(found.entries[1].outcome, Outcome::fails);
  EXPECT_TRUE(std::isnan(found.entries[2].value.value));
  ASSERT_EQ(j.findings.size(), 1u);
  EXPECT_EQ(j.findings[0], "Open choices (below): 3 samples per pair with the reference settings, 2 with each choice.");
}

TEST(PaperChoices, SayWhereAllPairsGiveAnotherVerdict) {
  Judgement j;
  add_choices(j, made_up(), "z", greatest, wanted_below(3));
  ASSERT_EQ(j.findings.size(), 2u);
  EXPECT_NE(
      j.findings[1].find(
          "5.0200 +- 0.0058 (fails) over all pairs, 2.0200 +- 0.0058 (holds) over those for which choices were varied"),
      std::string::npos)
      << j.findings[1];
}

TEST(PaperChoices, CountWhereTheyAreMadeAtEveryPair) {
  const Results whole = made_up();
  campaign::CollectedTable fewer = whole.table("paper-choices");
  std::erase_if(fewer.rows, [](const auto& row) { return row.values[0] == "2"; });
  fewer.rows.push_back(whole.table("paper-choices").rows[1]);
  fewer.rows.back().values[3] = "0.6";
  Results results;
  results.add("paper", whole.table("paper"));
  results.add("paper-choices", fewer);
  Judgement j;
  add_choices(j, results, "z", greatest, wanted_above(0));
  EXPECT_TRUE(std::isnan(j.sensitivities.front().entries[1].value.value));
}

TEST(PaperChoices, AreNotToldWithoutTheUsualRuns) {
  Judgement j;
  add_choices(j, Results(), "z", greatest, wanted_above(0));
  EXPECT_TRUE(j.sensitivities.empty() && j.findings.empty());
}

}  // namespace
}  // namespace arenite::validation
