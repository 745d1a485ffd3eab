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
      const double ratio = 27.35 / std::stod(stiffness),
                   z = 3.3 * (1 + change * std::log10(ratio)) + scatter * noise({1.0 * ratio, 1.0 * seed}) + 0.1 * seed;
      runs.push_back({{stiffness, std::to_string(seed)},
                      {z, z, 0.5, 0.25, 0.25, 1.75 + 0.001 * noise({1.0 * seed, 1.0 * ratio})}});
    }
  Results results;
  results.add("thesis-ch5", made_up_table({"materials.B.stiffness", "seed"},
                                          {"coordination.all", "coordination.without_rattlers",
                                           "coordination.share_of_contacts.A-B", "coordination.share_of_contacts.A-A",
                                           "coordination.share_of_contacts.B-B", "coordination.parts_of_z.A-B"},
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
      const double z = from + (to - from) * std::log10(ratio) - (ratio == 5 ? step_down : 0) +
                       0.02 * noise({1.0 * ratio, 1.0 * seed});
      runs.push_back({{std::to_string(ratio), std::to_string(seed)}, {z, z + 0.05}});
    }
  Results results;
  for (const char* study : {"thesis-ch4", "thesis-ch4-r"})
    results.add(study, made_up_table({"populations.1.ratio", "seed"},
                                     {"coordination.all", "coordination.without_rattlers"}, runs));
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
    for (int seed = 1; seed <= 5; ++seed)
      runs.push_back({{pom, std::to_string(seed)}, {0.45 + 0.001 * seed, 0.46 + 0.001 * seed, 0.47 + 0.001 * seed}});
  Results results;
  results.add(
      "thesis-ch3",
      made_up_table({"populations.0.count", "seed"},
                    {"sigma_norm.P0", "sigma_norm.by_material.POM.P0", "sigma_norm.by_material.HDPE.P0"}, runs));
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
    for (int set = 0; set < 3; ++set)
      numbers.insert(numbers.end(), {900, amplitude, phase + 2 * noise({1.0 * seed, 1.0 * set})});
    runs.push_back({{"1.060", std::to_string(seed)}, numbers});
  }
  std::vector<std::string> names;
  for (const char* path : {"fabric", "fabric.sets.dry-dry", "fabric.sets.glued-glued"})
    for (const char* number : {".contacts", ".modes.4.amplitude", ".modes.4.phase_deg"})
      names.push_back(std::string(path) + number);
  Results results;
  results.add("thesis-ch6", made_up_table({"contact.surface_energy", "seed"}, names, runs));
  return judge_t16(results);
}

TEST(PreferredDirections, OfALostSampleAreNotTestableWhateverRandomFillingsHave) {
  const auto checks = [](double amplitude, double phase) {
    const Judgement judgement = four_fold(amplitude, phase);
    EXPECT_EQ(judgement.verdict(), Verdict::not_testable);
    return std::pair(judgement.checks[0].outcome, judgement.checks[1].outcome);
  };
  EXPECT_EQ(checks(0.2, 45), std::pair(Outcome::holds, Outcome::holds));
  EXPECT_EQ(checks(0.2, 0), std::pair(Outcome::fails, Outcome::fails));
  EXPECT_EQ(checks(0.005, 45).first, Outcome::fails) << "less than one sample has by chance";
}

/// Shares of the strong contacts of each type among all contacts, at ten ratios; POM-POM lose `fall`, HDPE-HDPE gain as
/// much, and POM-HDPE rise to ratio 4 by `hump`.
Judgement strong_by_type(double fall, double hump) {
  std::vector<MadeUpRun> runs;
  for (int ratio = 1; ratio <= 10; ++ratio)
    for (int seed = 1; seed <= 10; ++seed) {
      const double way = (ratio - 1) / 9.0, chance = 0.003 * noise({1.0 * ratio, 1.0 * seed});
      const double mixed = 0.12 + hump * (1 - std::abs(ratio - 4.0) / 6);
      runs.push_back({{std::to_string(ratio), std::to_string(seed)},
                      {0.27 - fall * way + chance, 0.01 + fall * way - chance, mixed + chance, 1, 1, 1, 3, 2, 2, 1}});
    }
  std::vector<std::string> names;
  for (const char* number : {"strong_share_of_all", "mean_N", "maximum"})
    for (const char* type : {"POM-POM", "HDPE-HDPE", "HDPE-POM"})
      names.push_back(std::string("force.by_type.") + type + "." + number);
  Results results;
  results.add("thesis-ch4", made_up_table({"populations.1.ratio", "seed"}, names, runs));
  return judge_t19(results);
}

TEST(StrongContactsByType, AreSharesOfAllContacts) {
  EXPECT_EQ(strong_by_type(0.2, 0.08).verdict(), Verdict::reproduced);
  EXPECT_EQ(strong_by_type(-0.2, 0.08).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(strong_by_type(0.2, -0.08).verdict(), Verdict::not_reproduced) << "falls before it rises";
  EXPECT_NE(strong_by_type(0.2, 0).verdict(), Verdict::reproduced) << "the greatest of ten noisy means is no hump";
}

/// Shares above the mean stress of all, dry and glued grains, percent, in 25 samples.
Judgement shares_with_glue(double glued) {
  std::vector<MadeUpRun> runs;
  for (int seed = 1; seed <= 25; ++seed)
    runs.push_back({{"1.060", std::to_string(seed)},
                    {0.48 + 0.02 * noise({1.0 * seed}), 0.48 + 0.02 * noise({2.0 * seed}),
                     (glued + 5 * noise({3.0 * seed})) / 100}});
  Results results;
  results.add(
      "thesis-ch6",
      made_up_table({"contact.surface_energy", "seed"},
                    {"sigma_norm.P0", "sigma_norm.by_material.dry.P0", "sigma_norm.by_material.glued.P0"}, runs));
  return judge_t15(results);
}

TEST(SharesWithGlue, AreThoseOfTheTableWithinAMarginAndNoSideOfACoin) {
  EXPECT_EQ(shares_with_glue(50.6).verdict(), Verdict::reproduced)
      << "beyond one half, and within the scatter of one sample";
  EXPECT_EQ(shares_with_glue(57).verdict(), Verdict::not_reproduced);
}

/// Stress inside over outside, with glue and without in packings that differ by a tenth.
TEST(ChainsThatAvoidAnAgglomerate, AreSeenInTheSamePackings) {
  const auto judged = [](double change) {
    std::vector<MadeUpRun> runs;
    for (const char* glue : {"1.060", "0.000001"})
      for (int seed = 1; seed <= 10; ++seed) {
        const double packing = 1.08 + 0.1 * std::sin(7.0 * seed), scatter = 0.01 * noise({1.0 * seed, std::stod(glue)});
        const double inside = packing * (1 + (glue[0] == '1' ? change : 0) + scatter);
        runs.push_back({{glue, std::to_string(seed)}, {inside, 1, 0.005, 0.03}});
      }
    Results results;
    results.add("thesis-ch6",
                made_up_table({"contact.surface_energy", "seed"},
                              {"sigma_norm.by_material.glued.mean_Pa", "sigma_norm.by_material.dry.mean_Pa",
                               "force.tensile_share", "force.tensile.mean_over_compressive_mean"},
                              runs));
    return judge_t21(results).verdict();
  };
  EXPECT_EQ(judged(-0.06), Verdict::reproduced);
  EXPECT_EQ(judged(0.06), Verdict::not_reproduced);
}

}  // namespace
}  // namespace arenite::validation
