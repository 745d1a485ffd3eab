// Claims of the paper by made-up tables in which they are true, false, or not to be told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "unit/validation/made_up_table.hpp"
#include "validation/claims/claims.hpp"

namespace arenite::validation {
namespace {

const std::vector<std::string> keys{"bidisperse.size_ratio", "bidisperse.volume_ratio", "cement.kind", "cement.width",
                                    "seed"};

/// Full samples at nine gammas, two thetas, five seeds; two numbers of each.
Results full_samples(const std::vector<std::string>& names,
                     const std::function<std::vector<double>(double gamma, double chance)>& numbers) {
  std::vector<MadeUpRun> runs;
  for (const char* gamma : {"1", "1.11", "1.25", "1.43", "1.67", "2", "2.5", "3.33", "5"})
    for (const char* theta : {"1.4", "6"})
      for (int seed = 1; seed <= 5; ++seed)
        runs.push_back({{gamma, theta, "full", "", std::to_string(seed)},
                        numbers(std::stod(gamma), noise({std::stod(gamma), std::stod(theta), 1.0 * seed}))});
  Results results;
  results.add("paper", made_up_table(keys, names, runs));
  return results;
}

Judgement shape(double q_slope, double kurtosis_slope, double scatter) {
  return judge_p12(
      full_samples({"stress.sigma_yy.sets.large.q_gaussian.q", "stress.sigma_yy.sets.large.excess_kurtosis"},
                   [=](double gamma, double chance) {
                     return std::vector<double>{1.1 + q_slope * gamma + 0.01 * chance,
                                                0.5 + kurtosis_slope * gamma + scatter * chance};
                   }));
}

TEST(ShapeOfThePdf, IsATrendAndNotTheLastAgainstTheGreatestOfTheOthers) {
  // A slope of 0.02 beneath a scatter of 0.05: the greatest of eight noisy means is often above the last.
  EXPECT_EQ(shape(0.02, 0.02, 0.05).verdict(), Verdict::reproduced);
  EXPECT_EQ(shape(-0.02, 0.02, 0.05).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(shape(0.02, -0.05, 0.02).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(shape(0.02, 0, 0.05).verdict(), Verdict::undecided);
}

TEST(Packings, AreDrawnAnewWithoutOtherCements) {
  const Judgement of_packings = judge_p1(full_samples({"solid_fraction"}, [](double gamma, double chance) {
    return std::vector<double>{0.8 + 0.015 * gamma + 0.01 * chance};
  }));
  std::size_t of_all_pairs = 0, of_one = 0;
  for (const Check& check : of_packings.checks)
    for (const Draw& draw : check.draws) {
      const auto has = [&](const char* key) {
        return std::ranges::count(draw.where, key, [](auto& v) { return v.first; });
      };
      ++(has("bidisperse.size_ratio") && has("bidisperse.volume_ratio") ? of_one : of_all_pairs);
      EXPECT_EQ(std::ranges::count(draw.where, std::pair<std::string, std::string>{"cement.kind", "full"}), 1);
    }
  EXPECT_GT(of_all_pairs, 0u);
  EXPECT_GT(of_one, 0u);
}

Judgement means(double large, double large_slope, double small_end, double scatter) {
  return judge_p6(full_samples(
      {"stress.sigma_yy.sets.large.mean_over_sample_mean", "stress.sigma_yy.sets.small.mean_over_sample_mean"},
      [=](double gamma, double chance) {
        return std::vector<double>{large + large_slope * (gamma - 3) + scatter * chance,
                                   1.07 - (1.07 - small_end) * (gamma - 1) / 4 + scatter * chance};
      }));
}

TEST(MeansByClass, BelowOneIsBelowOne) {
  EXPECT_EQ(means(1.07, 0, 0.957, 0.002).verdict(), Verdict::reproduced) << "0.957 is below 1";
  EXPECT_EQ(means(1.07, 0, 1.02, 0.002).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(means(1.07, 0, 0.997, 0.02).verdict(), Verdict::undecided);
}

TEST(MeansByClass, WhateverGammaIsAMargin) {
  EXPECT_EQ(means(1.07, 0.003, 0.95, 0.001).verdict(), Verdict::reproduced)
      << "surely not zero, and less than 0.03 in all";
  EXPECT_EQ(means(1.07, 0.012, 0.95, 0.001).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(means(1.12, 0, 0.95, 0.001).verdict(), Verdict::trend_reproduced) << "about 1.07 is a number";
}

}  // namespace
}  // namespace arenite::validation
