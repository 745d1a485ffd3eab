#include "validation/claims/tail_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/validation/made_up_table.hpp"
#include "validation/checks.hpp"

namespace arenite::validation {
namespace {

/// Slopes of tails against S_m, which the width gives and gamma shifts.
Samples made_up(double (*slope)(double gamma, double saturation), Results& results) {
  std::vector<MadeUpRun> runs;
  for (const char* gamma : {"1", "2", "5"})
    for (const char* width : {"0.2", "0.4", "0.6", "0.8", "1.0"})
      for (int seed = 1; seed <= 4; ++seed) {
        const double g = std::stod(gamma), saturation = std::stod(width) * (0.5 + 0.08 * g);
        runs.push_back({{gamma, "1.4", "bridges", width, std::to_string(seed)},
                        {saturation, slope(g, saturation) + 0.01 * noise({1.0 * seed, g})}});
      }
  results.add("paper",
              made_up_table({"bidisperse.size_ratio", "bidisperse.volume_ratio", "cement.kind", "cement.width", "seed"},
                            {"S_m", "stress.sigma_yy.sets.large.tail.slope"}, runs));
  return paper_samples(results);
}

TEST(TailGrowth, WhatGammaDoesToTheSaturationIsNoEffectOfGamma) {
  // The slope hangs on S_m alone. At equal width, where larger gamma has larger S_m, it would seem to grow with both.
  Results results;
  const Samples samples = made_up([](double, double saturation) { return 3 * saturation * saturation; }, results);
  const Value effect = growth_of_effect(samples, "large");
  EXPECT_NEAR(effect.value, 0, 0.05);
  const auto at = [&](double width) { return pair_means(samples, "stress.sigma_yy.sets.large.tail.slope", width); };
  EXPECT_EQ(positive("", "", rise(against_gamma(difference(at(1), at(0.2)), 1.4))).outcome, Outcome::holds)
      << "so at equal width";
}

TEST(TailGrowth, AnEffectThatGrowsIsFoundAtEqualSaturation) {
  Results results;
  const Samples samples = made_up([](double gamma, double saturation) { return gamma * saturation; }, results);
  // From the greatest least S_m, 0.18, to the least greatest, 0.58.
  EXPECT_NEAR(growth_of_effect(samples, "large").value, 0.4, 0.02);
  EXPECT_EQ(positive("", "", growth_of_effect(samples, "large")).outcome, Outcome::holds);
}

TEST(TailGrowth, IsNotKnownWithoutRuns) {
  EXPECT_TRUE(std::isnan(growth_of_effect(paper_samples(Results()), "large").value));
}

}  // namespace
}  // namespace arenite::validation
