#include "ledger/claims/paper_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_checks.hpp"

namespace arenite::ledger {
namespace {

/// gamma 1, 2 and 5, theta 1.4 and 6, three samples; full, or of one width. `number` gives a run's value.
Results results(const std::string& name, double (*number)(double gamma, double theta, double width, int seed)) {
  study::CollectedTable t;
  t.keys = {{"bidisperse.size_ratio", ""}, {"bidisperse.volume_ratio", ""}, {"cement.kind", ""}, {"cement.width", ""}, {"seed", ""}};
  t.names = {name};
  for (const char* gamma : {"1", "2", "5"})
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

PairMeans z(const Results& r, double width) { return pair_means(paper_samples(r), "z", width); }

double sum(const PairMeans& means) {
  double sum = 0;
  for (const PairMean& m : means) sum += m.value.value;
  return sum;
}

TEST(PaperRuns, AreMeansOverSamplesOfOnePairCementedAlike) {
  const auto r = results("z", [](double gamma, double theta, double width, int seed) { return 100 * gamma + 10 * theta + width + seed; });
  const PairMeans means = z(r, 0.2);
  ASSERT_EQ(means.size(), 6u);
  EXPECT_EQ(means[0].gamma, 1);
  EXPECT_EQ(means[0].theta, 1.4);
  EXPECT_NEAR(means[0].value.value, 100 + 14 + 0.2 + 1, 1e-12);
  EXPECT_NEAR(means[0].value.error, 1 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(of_pair(z(r, full), 5, 6).value, 561, 1e-12);
  EXPECT_TRUE(std::isnan(of_pair(means, 3, 6).value));
  EXPECT_NEAR(overall(means).error, 1 / std::sqrt(18.0), 1e-12);
}

TEST(PaperRuns, StressesAreOfTheComponentAlongTheLoad) {
  const auto r = results("stress.sigma_xy.sets.large.variance", [](double, double, double, int) { return 3.0; });
  Samples samples = paper_samples(r);
  EXPECT_TRUE(stress_means(samples, "large", "variance").empty());
  samples.component = "sigma_xy";
  EXPECT_EQ(of_pair(stress_means(samples, "large", "variance"), 1, 6).value, 3);
}

TEST(PaperRuns, CementsOfOnePackingAreComparedSampleBySample) {
  // Packings differ by far more than what the cement changes.
  const auto r = results("z", [](double, double, double width, int seed) { return 100 * seed + width + 0.01 * seed * width; });
  const Value change = of_pair(difference(z(r, 1), z(r, 0.2)), 1, 6);
  EXPECT_NEAR(change.value, 0.8 + 0.008, 1e-12);
  EXPECT_NEAR(change.error, 0.008 / std::sqrt(3.0), 1e-12);
}

TEST(PaperRuns, TheJackknifeOfAMeanIsItsStandardError) {
  const auto r = results("z", [](double gamma, double, double, int seed) { return gamma + (gamma == 2 ? seed * seed : 0); });
  const PairMeans two = only(z(r, full), [](const PairMean& m) { return m.gamma == 2 && m.theta == 6; });
  const Value found = jackknifed(two, sum);
  EXPECT_NEAR(found.value, two.front().value.value, 1e-12);
  EXPECT_NEAR(found.error, two.front().value.error, 1e-12);
  EXPECT_TRUE(std::isnan(jackknifed(PairMeans{}, sum).error));
}

TEST(PaperRuns, TheJackknifeLeavesOutSamplesOfOnePackingTogether) {
  const auto r = results("z", [](double, double, double, int seed) { return 1.0 + seed; });
  const Value same = jackknifed({z(r, full), z(r, 1)}, [](const std::vector<PairMeans>& both) { return sum(both[0]) - sum(both[1]); });
  EXPECT_NEAR(same.error, 0, 1e-12);
}

TEST(PaperChecks, ARangeTellsBothEnds) {
  const auto r = results("z", [](double gamma, double, double, int) { return gamma; });
  Verdict verdict;
  add_range(verdict, "z", "", z(r, full), 1, 4);
  ASSERT_EQ(verdict.checks.size(), 2u);
  EXPECT_EQ(verdict.checks[0].holds, Holds::yes);
  EXPECT_EQ(verdict.checks[1].holds, Holds::no);
  Verdict nothing;
  add_range(nothing, "z", "", {}, 1, 4);
  EXPECT_EQ(nothing.holds(), Holds::unknown);
}

TEST(PaperChecks, OnePairThatGoesTheOtherWaySpoilsATrend) {
  const auto up = results("z", [](double, double, double width, int seed) { return width + 0.01 * seed * width; });
  EXPECT_EQ(in_all_pairs("z", "", difference(z(up, 1), z(up, 0.2)), +1).holds, Holds::yes);
  EXPECT_EQ(in_all_pairs("z", "", difference(z(up, 1), z(up, 0.2)), -1).holds, Holds::no);
  const auto mixed = results("z", [](double gamma, double theta, double width, int seed) { return (gamma == 5 && theta == 6 ? -1 : 1) * width * (1 + 0.01 * seed); });
  EXPECT_EQ(in_all_pairs("z", "", difference(z(mixed, 1), z(mixed, 0.2)), +1).holds, Holds::no);
}

TEST(PaperChecks, EveryPairMustBeBeyondItsOwnErrors) {
  const auto r = results("z", [](double gamma, double theta, double, int seed) { return 1 + (gamma == 5 && theta == 6 ? 2 : 0.1) * (seed - 1); });
  EXPECT_EQ(in_all_pairs("z", "", z(r, full), +1).holds, Holds::yes);
  const Check every = in_every_pair("z", "", z(r, full), +1);
  EXPECT_EQ(every.holds, Holds::no);
  EXPECT_NE(every.what.find("5 of 6 pairs"), std::string::npos) << every.what;
  EXPECT_NE(every.what.find("gamma 5, theta 6"), std::string::npos) << every.what;
  EXPECT_EQ(in_every_pair("z", "", of_theta(z(r, full), 1.4), +1).holds, Holds::yes);
  EXPECT_EQ(in_every_pair("z", "", {}, +1).holds, Holds::unknown);
}

TEST(PaperChecks, ALineIsStraightAndRises) {
  const auto line = results("z", [](double gamma, double, double, int seed) { return gamma + 0.01 * seed; });
  const Check against_gamma = straight("z", "", z(line, full), 6, Against::gamma);
  EXPECT_EQ(against_gamma.holds, Holds::yes);
  EXPECT_NEAR(against_gamma.ours, 1, 1e-12);
  EXPECT_TRUE(std::isfinite(against_gamma.error));
  EXPECT_EQ(straight("z", "", z(line, full), 6, Against::inverse_gamma).holds, Holds::no);
  EXPECT_EQ(straight("z", "", z(line, full), 2.2, Against::gamma).holds, Holds::unknown);
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
