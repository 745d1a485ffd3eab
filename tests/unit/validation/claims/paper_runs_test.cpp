#include "validation/claims/paper_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/validation/made_up_table.hpp"
#include "validation/claims/paper_checks.hpp"
#include "validation/claims/paper_errors.hpp"

namespace arenite::validation {
namespace {

/// gamma 1, 2 and 5, theta 1.4 and 6, three samples; full, or of one width. `number` gives a run's value.
Results results(const std::string& name, double (*number)(double gamma, double theta, double width, int seed)) {
  campaign::CollectedTable t;
  t.keys = {{"bidisperse.size_ratio", ""},
            {"bidisperse.volume_ratio", ""},
            {"cement.kind", ""},
            {"cement.width", ""},
            {"seed", ""}};
  t.names = {name};
  for (const char* gamma : {"1", "2", "5"})
    for (const char* theta : {"1.4", "6"})
      for (const char* width : {"", "0.2", "1.0"})
        for (int seed = 0; seed < 3; ++seed) {
          const bool is_full = width[0] == '\0';
          const double value = number(std::stod(gamma), std::stod(theta), is_full ? 0 : std::stod(width), seed);
          t.rows.push_back({std::to_string(t.rows.size()),
                            "done",
                            {gamma, theta, is_full ? "full" : "", width, std::to_string(seed)},
                            1,
                            {campaign::Estimate{value}}});
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
  const auto r = results(
      "z", [](double gamma, double theta, double width, int seed) { return 100 * gamma + 10 * theta + width + seed; });
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
  const auto r =
      results("z", [](double, double, double width, int seed) { return 100 * seed + width + 0.01 * seed * width; });
  const Value change = of_pair(difference(z(r, 1), z(r, 0.2)), 1, 6);
  EXPECT_NEAR(change.value, 0.8 + 0.008, 1e-12);
  EXPECT_NEAR(change.error, 0.008 / std::sqrt(3.0), 1e-12);
}

TEST(PaperRuns, TheJackknifeOfAMeanIsItsStandardError) {
  const auto r =
      results("z", [](double gamma, double, double, int seed) { return gamma + (gamma == 2 ? seed * seed : 0); });
  const PairMeans two = only(z(r, full), [](const PairMean& m) { return m.gamma == 2 && m.theta == 6; });
  const Value found = jackknifed(two, sum);
  EXPECT_NEAR(found.value, two.front().value.value, 1e-12);
  EXPECT_NEAR(found.error, two.front().value.error, 1e-12);
  EXPECT_TRUE(std::isnan(jackknifed(PairMeans{}, sum).error));
}

TEST(PaperRuns, TheJackknifeLeavesOutSamplesOfOnePackingTogether) {
  const auto r = results("z", [](double, double, double, int seed) { return 1.0 + seed; });
  const Value same =
      jackknifed({z(r, full), z(r, 1)}, [](const std::vector<PairMeans>& both) { return sum(both[0]) - sum(both[1]); });
  EXPECT_NEAR(same.error, 0, 1e-12);
}

TEST(PaperChecks, ARangeTellsThePairThatIsFurthestOutside) {
  const auto r = results("z", [](double gamma, double, double, int seed) { return gamma + 0.001 * seed; });
  EXPECT_EQ(in_range("z", "", z(r, full), 0.9, 5.1).outcome, Outcome::holds);
  const Check check = in_range("z", "", z(r, full), 0.9, 4);
  EXPECT_EQ(check.outcome, Outcome::fails);
  EXPECT_NEAR(check.ours.value, 5.001, 1e-12);
  EXPECT_EQ(in_range("z", "", {}, 1, 4).outcome, Outcome::unknown);
}

TEST(PaperChecks, MembersArePairsWithTheFreedomOfTheirSamples) {
  const auto r = results("z", [](double gamma, double, double, int seed) { return gamma + 0.001 * seed; });
  const Family family = members(z(r, full));
  ASSERT_EQ(family.size(), 6u);
  EXPECT_EQ(family[1].name, "gamma 1, theta 6");
  EXPECT_EQ(family[1].value.freedom, 12) << "of six pairs together";
  EXPECT_NEAR(overall(z(r, full)).freedom, 12, 1e-9) << "and no more in their mean";
  EXPECT_EQ(slope(against_gamma(z(r, full), 6)).freedom, 12);
  ASSERT_EQ(family[1].draws.size(), 1u);
  EXPECT_EQ(family[1].draws[0], (Draw{"paper", {{"bidisperse.size_ratio", "1"}, {"bidisperse.volume_ratio", "6"}}}));
}

TEST(PaperErrors, AreOfOneVarianceWhereItIsOne) {
  const auto even = results("z", [](double gamma, double theta, double, int seed) {
    return noise({gamma, theta, 1.0 * seed});
  });
  double squares = 0;
  for (const PairMean& m : z(even, full))
    for (const Sample& s : m.samples) squares += std::pow(s.number - m.value.value, 2) / 12;
  for (const PairMean& m : z(even, full)) {
    EXPECT_NEAR(m.value.error, std::sqrt(squares / 3), 1e-12);
    EXPECT_EQ(m.value.freedom, 12);
  }
}

TEST(PaperErrors, AreOfThePairsOfOneGammaOrOfOnePairWhereTheyDiffer) {
  // Samples scatter a hundred times as much at each greater gamma, and at gamma 5 also at each greater theta.
  const auto wide = results("z", [](double gamma, double theta, double, int seed) {
    return std::pow(100, gamma) * (gamma == 5 ? theta * theta * theta : 1) * noise({gamma, theta, 1.0 * seed});
  });
  const PairMeans means = z(wide, full);
  for (const PairMean& m : means) EXPECT_EQ(m.value.freedom, m.gamma == 5 ? 2 : 4) << name_of(m);
  EXPECT_EQ(means[0].value.error, means[1].value.error);
}

TEST(PaperErrors, OfALineHaveTheFreedomOfAllItsPackings) {
  const auto line = results("z", [](double gamma, double theta, double width, int seed) {
    return gamma + 0.1 * noise({gamma, theta, width, 1.0 * seed});
  });
  const Value r2 = straightness(z(line, full), 6, Against::gamma);
  EXPECT_GT(r2.freedom, 2) << "three pairs of three samples are more than three samples";
  EXPECT_LE(r2.freedom, 6 + 1e-9);
}

TEST(PaperChecks, ATrendWithGammaIsASlopeAtEveryTheta) {
  const auto up = results("z", [](double gamma, double, double, int seed) { return gamma + 0.01 * seed; });
  EXPECT_EQ(with_gamma("z", "", z(up, full), +1).outcome, Outcome::holds);
  EXPECT_EQ(with_gamma("z", "", z(up, full), -1).outcome, Outcome::fails);
  const auto mixed = results(
      "z", [](double gamma, double theta, double, int seed) { return (theta == 6 ? -1 : 1) * gamma + 0.01 * seed; });
  EXPECT_EQ(with_gamma("z", "", z(mixed, full), +1).outcome, Outcome::fails);
  EXPECT_EQ(with_gamma("z", "", {}, +1).outcome, Outcome::unknown);
}

TEST(PaperChecks, CementsOfOnePackingAreNotIndependent) {
  // The same difference at both widths: twice as many numbers are not twice the samples.
  const auto r = results("z", [](double, double, double, int seed) { return 1.0 + 0.1 * seed; });
  const Value both = overall(mean_of({z(r, 0.2), z(r, 1)}));
  EXPECT_NEAR(both.error, overall(z(r, 0.2)).error, 1e-12);
  EXPECT_NEAR(both.freedom, 12, 1e-9);
}

TEST(PaperChecks, ALineIsStraight) {
  const auto line = results("z", [](double gamma, double, double, int seed) { return gamma + 0.01 * seed; });
  const Check against_gamma = straight("z", "", z(line, full), Against::gamma);
  EXPECT_EQ(against_gamma.outcome, Outcome::holds);
  EXPECT_NEAR(against_gamma.ours.value, 1, 1e-12);
  EXPECT_TRUE(std::isfinite(against_gamma.ours.error));
  EXPECT_EQ(straight("z", "", z(line, full), Against::inverse_gamma).outcome, Outcome::fails);
  EXPECT_EQ(straight("z", "", of_theta(z(line, full), 2.2), Against::gamma).outcome, Outcome::unknown);
}

TEST(PaperChecks, TheLowestOfNoisyMeansIsNoDip) {
  // A level line: the least of its means lies below the first and the last, and is not found there again in other
  // samples.
  const auto level = results("z", [](double gamma, double theta, double width, int seed) {
    return noise({gamma, theta, width, 1.0 * seed});
  });
  const Dip none = dip(z(level, full), 6);
  EXPECT_NE(positive("", "", none.fall).outcome, Outcome::holds);
  EXPECT_NE(positive("", "", none.rise).outcome, Outcome::holds);
  const auto dipped = results("z", [](double gamma, double theta, double width, int seed) {
    return (gamma == 2 ? 0 : gamma) + 0.05 * noise({gamma, theta, width, 1.0 * seed});
  });
  const Dip found = dip(z(dipped, full), 6);
  EXPECT_EQ(positive("", "", found.fall).outcome, Outcome::holds);
  EXPECT_NEAR(found.fall.value, 1, 0.1);
  EXPECT_NEAR(found.rise.value, 5, 0.1);
}

TEST(PaperChecks, TheGreatestOfNoisyMeansIsLookedForInOtherSamples) {
  // Widths that do not differ: on average what is greatest without a sample is no greater in it.
  const auto level = results("z", [](double gamma, double theta, double width, int seed) {
    return noise({gamma, theta, width, 1.0 * seed});
  });
  const std::vector<PairMeans> sizes{z(level, 0.2), z(level, 1)};
  const PairMeans lead = difference(at_greatest(sizes, sizes), sizes.front());
  EXPECT_NE(positive("", "", overall(lead)).outcome, Outcome::holds);
  const auto wide = results("z", [](double gamma, double theta, double width, int seed) {
    return width + 0.05 * noise({gamma, theta, width, 1.0 * seed});
  });
  const std::vector<PairMeans> rising{z(wide, 0.2), z(wide, 1)};
  EXPECT_NEAR(overall(difference(at_greatest(rising, rising), rising.front())).value, 0.8, 0.05);
}

}  // namespace
}  // namespace arenite::validation
