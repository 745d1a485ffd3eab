#include "ledger/claims/paper_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ledger/claims/claims.hpp"

namespace arenite::ledger {
namespace {

/// gamma 1 and 5, theta 1.4 and 6, three seeds; full, or of one width. `number` gives a run's value.
Results results(const std::string& name, double (*number)(double gamma, double theta, double width, int seed)) {
  study::CollectedTable t;
  t.keys = {{"bidisperse.size_ratio", ""}, {"bidisperse.volume_ratio", ""}, {"cement.kind", ""}, {"cement.width", ""}, {"seed", ""}};
  t.names = {name};
  for (const char* gamma : {"1", "5"})
    for (const char* theta : {"1.4", "6"})
      for (const char* width : {"", "0.2", "1.0"})
        for (int seed = 0; seed < 3; ++seed) {
          const bool is_full = width[0] == '\0';
          const double value = number(std::stod(gamma), std::stod(theta), is_full ? 0 : std::stod(width), seed);
          t.rows.push_back({std::to_string(t.rows.size()), "done", {gamma, theta, is_full ? "full" : "", width, std::to_string(seed)}, 1, {study::Estimate{value, {}}}});
        }
  Results r;
  r.add("paper", t);
  return r;
}

TEST(PaperRuns, AreMeansOverSamplesOfOnePairCementedAlike) {
  const auto r = results("z", [](double gamma, double theta, double width, int seed) { return 100 * gamma + 10 * theta + width + seed; });
  const PairMeans means = pair_means(r, "z", 0.2);
  ASSERT_EQ(means.size(), 4u);
  EXPECT_EQ(means[0].gamma, 1);
  EXPECT_EQ(means[0].theta, 1.4);
  EXPECT_NEAR(means[0].value.value, 100 + 14 + 0.2 + 1, 1e-12);
  EXPECT_NEAR(means[0].value.error, 1 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(of_pair(pair_means(r, "z", full), 5, 6).value, 561, 1e-12);
  EXPECT_TRUE(std::isnan(of_pair(means, 2, 6).value));
  EXPECT_NEAR(overall(means).error, 1 / std::sqrt(12.0), 1e-12);
}

TEST(PaperRuns, ARangeTellsBothEnds) {
  const auto r = results("z", [](double gamma, double, double, int) { return gamma; });
  Verdict verdict;
  add_range(verdict, "z", "", pair_means(r, "z", full), 1, 4);
  ASSERT_EQ(verdict.checks.size(), 2u);
  EXPECT_EQ(verdict.checks[0].holds, Holds::yes);
  EXPECT_EQ(verdict.checks[1].holds, Holds::no);
  Verdict nothing;
  add_range(nothing, "z", "", {}, 1, 4);
  EXPECT_EQ(nothing.holds(), Holds::unknown);
}

TEST(PaperRuns, OnePairThatGoesTheOtherWaySpoilsATrend) {
  const auto up = results("z", [](double, double, double width, int seed) { return width + 0.01 * seed; });
  EXPECT_EQ(in_all_pairs("z", "", difference(pair_means(up, "z", 1), pair_means(up, "z", 0.2)), +1).holds, Holds::yes);
  EXPECT_EQ(in_all_pairs("z", "", difference(pair_means(up, "z", 1), pair_means(up, "z", 0.2)), -1).holds, Holds::no);
  const auto mixed = results("z", [](double gamma, double theta, double width, int seed) { return (gamma == 5 && theta == 6 ? -1 : 1) * width + 0.01 * seed; });
  EXPECT_EQ(in_all_pairs("z", "", difference(pair_means(mixed, "z", 1), pair_means(mixed, "z", 0.2)), +1).holds, Holds::no);
}

TEST(PaperClaims, WithoutRunsAreUnknown) {
  const Results nothing;
  for (const Claim& claim : claims())
    if (claim.id[0] == 'P') {
      const Judgement j = claim.judge(nothing);
      EXPECT_EQ(j.stated.holds(), Holds::unknown) << claim.id;
      EXPECT_EQ(j.sharpened.holds(), Holds::unknown) << claim.id;
    }
}

}  // namespace
}  // namespace arenite::ledger
