#include "validation/claims/paper_loads.hpp"

#include <gtest/gtest.h>

#include "unit/validation/made_up_table.hpp"
#include "validation/claims/paper_checks.hpp"

namespace arenite::validation {
namespace {

const std::vector<std::string> load_keys{"bidisperse.size_ratio", "bidisperse.volume_ratio", "cement.kind",
                                         "loads.0.loading", "seed"};
const std::vector<std::string> load_numbers{"modulus_Pa", "stress.sigma_yy.sets.large.mean_Pa",
                                            "stress.sigma_xy.sets.large.variance"};

Results made_up(double pushed_modulus) {
  std::vector<MadeUpRun> runs;
  for (const char* seed : {"1", "2"}) {
    runs.push_back({{"5", "1.4", "full", "tension", seed}, {7, 3, 1}});
    runs.push_back({{"5", "1.4", "full", "compression", seed}, {pushed_modulus, -3, 1}});
    runs.push_back({{"5", "1.4", "full", "shear", seed}, {2, 0, 4 + 0.1 * std::stod(seed)}});
  }
  Results results;
  results.add("paper-loads", made_up_table(load_keys, load_numbers, runs));
  return results;
}

TEST(PaperLoads, CompressionIsComparedNumberByNumber) {
  Judgement same, other;
  add_compression(same, made_up(7));
  ASSERT_EQ(same.findings.size(), 1u);
  EXPECT_NE(same.findings[0].find("of 6 numbers of 2 samples loaded in both directions, 0 differ"), std::string::npos)
      << same.findings[0];
  add_compression(other, made_up(7.000000001));
  EXPECT_NE(other.findings[0].find("2 differ"), std::string::npos) << other.findings[0];
}

TEST(PaperLoads, ShearIsJudgedByItsOwnComponentBesideTheClaim) {
  const auto asked = [](double bound) {
    return [=](const Samples& samples) {
      std::vector<Check> checks;
      for (const PairMean& m : stress_means(samples, "large", "variance"))
        checks = {above("variance", "", m.value, 0), below("variance", "", m.value, bound)};
      return checks;
    };
  };
  Judgement j;
  add_shear(j, made_up(7), asked(5));
  add_shear(j, made_up(7), asked(3));
  ASSERT_EQ(j.findings.size(), 2u);
  EXPECT_EQ(j.findings[0], "In shear (sigma_xy), 2 of 2 corresponding checks hold.");
  EXPECT_EQ(j.findings[1],
            "In shear (sigma_xy), 1 of 2 corresponding checks hold; failing: variance (4.150 +- 0.050).");
  EXPECT_EQ(j.checks.size(), 4u);
  EXPECT_EQ(j.verdict(), Verdict::unknown) << "what is told beside decides nothing";
}

TEST(PaperLoads, WithoutRunsSayNothing) {
  Judgement j;
  add_shear(j, Results(), [](const Samples&) { return std::vector<Check>(); });
  add_compression(j, Results());
  EXPECT_TRUE(j.findings.empty());
}

}  // namespace
}  // namespace arenite::validation
