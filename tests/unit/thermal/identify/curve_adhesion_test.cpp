#include "thermal/identify/curve.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace {
using namespace arenite;
using namespace arenite::identify;
using identify::Curve;

/// A straight pull to 100 N at point 80 of 100, then nothing.
Curve pulled(double noise = 0, std::uint64_t seed = 1) {
  RandomStream random(seed, Purpose::test);
  Curve c{"pull.csv", "specimen 2", {}, {}, {}};
  for (int p = 0; p < 100; ++p) {
    c.x.push_back(p * 1e-6), c.y.push_back((p <= 80 ? 1.25 * p : 0) + noise * random.normal());
    c.line.push_back(p + 2);
  }
  return c;
}

TEST(Adhesion, RadiiOfEqualCylindersAreAlike) {
  for (const auto kind : {EffectiveRadius::four_reduced, EffectiveRadius::sum, EffectiveRadius::geometric_mean})
    EXPECT_DOUBLE_EQ(effective_radius(kind, 6.2e-3, 6.2e-3), 12.4e-3);
  EXPECT_DOUBLE_EQ(effective_radius(EffectiveRadius::four_reduced, 1, 3), 3);
  EXPECT_DOUBLE_EQ(effective_radius(EffectiveRadius::sum, 1, 3), 4);
  EXPECT_DOUBLE_EQ(effective_radius(EffectiveRadius::geometric_mean, 1, 4), 4);
}

RC_GTEST_PROP(Adhesion, ThresholdIsTheLeastForceOfTheLaw, ()) {
  const double k = *rc::gen::inRange(1, 100) * 1e6, gamma = *rc::gen::inRange(1, 100) * 1e4,
               r = *rc::gen::inRange(1, 50) * 1e-3;
  const auto law = [&](double h) { return k * h - gamma * std::sqrt(r * h); };
  const auto at = threshold(gamma, k, r);
  RC_ASSERT(std::abs(law(at.overlap) + at.force) < 1e-9 * at.force);
  RC_ASSERT(law(0.99 * at.overlap) > -at.force && law(1.01 * at.overlap) > -at.force);
  RC_ASSERT(std::abs(law(at.free_overlap)) < 1e-9 * at.force);
  RC_ASSERT(std::abs(surface_energy({at.force}, {k}, r).value - gamma) < 1e-9 * gamma);
}

TEST(Adhesion, HalfTheRelativeErrorsOfForceAndStiffness) {
  const auto gamma = surface_energy({100, 6, 4}, {27.35e6, 0.8 / 27.35 * 27.35e6}, 12.4e-3);
  EXPECT_NEAR(gamma.error / gamma.value, 0.5 * std::hypot(0.06, 0.8 / 27.35), 1e-12);
  EXPECT_GT(gamma.freedom, 4);
}

TEST(Adhesion, ThePeakOfAPull) {
  const auto exact = pull_off(pulled());
  EXPECT_DOUBLE_EQ(exact.force.value, 100);
  EXPECT_LT(exact.force.error, 1e-12);
  EXPECT_TRUE(exact.separated);
  double error = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) error += pull_off(pulled(0.5, seed)).force.error / 200;
  EXPECT_NEAR(error, 0.5, 0.05);
}

TEST(Adhesion, ARecordThatEndsAtItsPeakIsMarked) {
  Curve cut = pulled();
  cut.x.resize(81), cut.y.resize(81), cut.line.resize(81);
  EXPECT_FALSE(pull_off(cut).separated);
  cut.y = {1, 2, 3}, cut.x = {0, 1, 2};
  EXPECT_TRUE(std::isnan(pull_off(cut).force.error));
}

TEST(Adhesion, BadRecords) {
  Curve pushed = pulled();
  for (double& y : pushed.y) y = -y - 1;
  try {
    pull_off(pushed);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(to_string(error.problems().front()),
              "pull.csv:2: specimen 2: the force is never a tension; write tension as positive force");
  }
  EXPECT_THROW(pull_off({"pull.csv", "", {1, 2}, {1, 2}, {2, 3}}), InputError);
}

}  // namespace
