// Claims of the thesis by made-up tables in which they are true, false, or not to be told.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/validation/made_up_table.hpp"
#include "validation/claims/claims.hpp"

namespace arenite::validation {
namespace {

/// z against the stiffness ratio: a part of it more over a decade.
Judgement steady(double change, double scatter) {
  std::vector<MadeUpRun> runs;
  for (const char* stiffness : {"27.35", "6.8375", "2.735"})
    for (int seed = 1; seed <= 10; ++seed) {
      const double ratio = 27.35 / std::stod(stiffness), z = 3.3 * (1 + change * std::log10(ratio)) + scatter * noise({1.0 * ratio, 1.0 * seed}) + 0.1 * seed;
      runs.push_back({{stiffness, std::to_string(seed)}, {z, z, 0.5, 0.25, 0.25, 1.75 + 0.001 * noise({1.0 * seed, 1.0 * ratio})}});
    }
  Results results;
  results.add("thesis-ch5", made_up_table({"materials.B.stiffness", "seed"},
                                          {"coordination.all", "coordination.without_rattlers", "coordination.share_of_contacts.A-B",
                                           "coordination.share_of_contacts.A-A", "coordination.share_of_contacts.B-B", "coordination.parts_of_z.A-B"},
                                          runs));
  return judge_t13(results);
}

TEST(SteadyCoordination, IsEqualWithinAMarginAndNotMerelyNotSignificant) {
  EXPECT_EQ(steady(0.02, 0.001).checks[0].outcome, Outcome::holds) << "surely not zero, and small";
  EXPECT_EQ(steady(0.02, 0.5).checks[0].outcome, Outcome::undecided) << "not significant for scatter";
  EXPECT_EQ(steady(0.12, 0.001).checks[0].outcome, Outcome::fails);
  EXPECT_EQ(steady(0.02, 0.001).verdict(), Verdict::reproduced);
}

/// z at ten ratios under both laws.
Judgement rising(double from, double to, double step_down) {
  std::vector<MadeUpRun> runs;
  for (int ratio = 1; ratio <= 10; ++ratio)
    for (int seed = 1; seed <= 5; ++seed) {
      const double z = from + (to - from) * std::log10(ratio) - (ratio == 5 ? step_down : 0) + 0.02 * noise({1.0 * ratio, 1.0 * seed});
      runs.push_back({{std::to_string(ratio), std::to_string(seed)}, {z, z + 0.05}});
    }
  Results results;
  for (const char* study : {"thesis-ch4", "thesis-ch4-r"})
    results.add(study, made_up_table({"populations.1.ratio", "seed"}, {"coordination.all", "coordination.without_rattlers"}, runs));
  return judge_t8(results);
}

TEST(RisingCoordination, IsATrendWhateverItsNumbers) {
  EXPECT_EQ(rising(4.3, 4.9, 0).verdict(), Verdict::reproduced);
  EXPECT_EQ(rising(3.64, 3.76, 0).verdict(), Verdict::trend_reproduced) << "a rise of 0.12 is a rise";
  EXPECT_EQ(rising(4.9, 4.3, 0).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(rising(4.3, 4.9, 0.4).verdict(), Verdict::not_reproduced) << "monotone";
}

/// Shares above the mean of three samples.
TEST(SharesAboveTheMean, AreSetAgainstATableThatContradictsItsSentence) {
  std::vector<MadeUpRun> runs;
  for (const char* pom : {"638", "334", "86"})
    for (int seed = 1; seed <= 5; ++seed) runs.push_back({{pom, std::to_string(seed)}, {0.45 + 0.001 * seed, 0.46 + 0.001 * seed, 0.47 + 0.001 * seed}});
  Results results;
  results.add("thesis-ch3",
              made_up_table({"populations.0.count", "seed"}, {"sigma_norm.P0", "sigma_norm.by_material.POM.P0", "sigma_norm.by_material.HDPE.P0"}, runs));
  const Judgement judgement = judge_t5(results);
  EXPECT_EQ(judgement.checks[0].outcome, Outcome::holds);
  EXPECT_EQ(judgement.checks[1].outcome, Outcome::holds);
  EXPECT_EQ(judgement.verdict(), Verdict::source_inconsistent);
}

/// 4-fold order of contact orientations: amplitude and phase in every one of eight samples.
Judgement four_fold(double amplitude, double phase) {
  std::vector<MadeUpRun> runs;
  for (int seed = 1; seed <= 8; ++seed) {
    std::vector<double> numbers;
    for (int set = 0; set < 3; ++set) numbers.insert(numbers.end(), {900, amplitude, phase + 2 * noise({1.0 * seed, 1.0 * set})});
    runs.push_back({{"1.060", std::to_string(seed)}, numbers});
  }
  std::vector<std::string> names;
  for (const char* path : {"fabric", "fabric.sets.dry-dry", "fabric.sets.glued-glued"})
    for (const char* number : {".contacts", ".modes.4.amplitude", ".modes.4.phase_deg"}) names.push_back(std::string(path) + number);
  Results results;
  results.add("thesis-ch6", made_up_table({"contact.surface_energy", "seed"}, names, runs));
  return judge_t16(results);
}

TEST(PreferredDirections, AreNotThereBecauseTheyAreReported) {
  EXPECT_EQ(four_fold(0.2, 45).verdict(), Verdict::reproduced);
  EXPECT_EQ(four_fold(0.2, 0).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(four_fold(0.005, 45).verdict(), Verdict::not_reproduced) << "less than one sample has by chance";
}

}  // namespace
}  // namespace arenite::validation
