#include "thermal/identify/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace {
using namespace arenite;
using identify::Curve;
using identify::cycles_of;

constexpr double k = 27.35e6;

/// Loadings to these peaks (N) and back, `points` each way: the cylinder settles below 1 kN, then F = k delta.
Curve record(const std::vector<double>& peaks, int points = 200, double noise = 0, std::uint64_t seed = 1,
             double sign = 1) {
  RandomStream random(seed, Purpose::test);
  Curve c{"test.csv", "", {}, {}, {}};
  for (const double peak : peaks)
    for (int p = 0; p < 2 * points; ++p) {
      const double share = p < points ? p / double(points - 1) : (2 * points - 1 - p) / double(points - 1);
      const double force = 50 + share * (peak - 50),
                   settling = force < 1000 ? 0.2e-3 * std::sqrt(force / 1000) : 0.2e-3;
      c.x.push_back(settling + force / k + noise * random.normal());
      c.y.push_back(sign * force);
      c.line.push_back(static_cast<int>(c.line.size()) + 2);
    }
  return c;
}

std::string stiffness_complaint(const Curve& curve, const identify::StiffnessOptions& options = {}) {
  try {
    cycles_of(curve, options);
  } catch (const InputError& error) { return to_string(error.problems().front()); }
  return "";
}

TEST(Stiffness, EveryCycleOfARecordGivesItsSlope) {
  const auto cycles = cycles_of(record({6000, 8000, 20000}));
  ASSERT_EQ(cycles.size(), 3U);
  for (const auto& c : cycles) EXPECT_NEAR(c.stiffness.value, k, 1e-9 * k);
  EXPECT_NEAR(cycles[0].peak, 6000, 1e-9);
  EXPECT_NEAR(cycles[2].peak, 20000, 1e-9);
}

TEST(Stiffness, CompressionMayBeNegativeAndDisplacementMayRunEitherWay) {
  EXPECT_NEAR(cycles_of(record({6000}, 200, 0, 1, -1)).front().stiffness.value, k, 1e-9 * k);
  Curve turned = record({6000});
  for (double& x : turned.x) x = -x;
  EXPECT_NEAR(cycles_of(turned).front().stiffness.value, k, 1e-9 * k);
}

TEST(Stiffness, OnlyBeyondThePreload) {
  const double bent = cycles_of(record({6000}), {100}).front().stiffness.value;
  EXPECT_LT(bent, 0.95 * k);
}

TEST(Stiffness, UnloadingIsAnotherBranch) {
  Curve c = record({6000});
  for (std::size_t p = 200; p < 400; ++p) c.x[p] = c.x[199] - (6000 - c.y[p]) / (2 * k);
  EXPECT_NEAR(cycles_of(c, {1000, identify::Branch::unloading}).front().stiffness.value, 2 * k, 1e-9 * k);
  EXPECT_NEAR(cycles_of(c).front().stiffness.value, k, 1e-9 * k);
}

TEST(Stiffness, IntervalsCoverTheTruth) {
  int covered = 0, seeds = 1000;
  for (int seed = 0; seed < seeds; ++seed) {
    const auto cycle = cycles_of(record({8000}, 60, 3e-6, static_cast<std::uint64_t>(seed))).front();
    const auto range = statistics::confidence_95(cycle.stiffness);
    covered += range.low <= k && k <= range.high;
  }
  EXPECT_NEAR(covered / double(seeds), 0.95, 0.025);
}

TEST(Stiffness, NoiseOfTheForceMakesNoCycles) {
  Curve c = record({20000});
  RandomStream random(5, Purpose::test);
  for (double& y : c.y) y += 60 * random.normal();
  EXPECT_EQ(cycles_of(c).size(), 1U);
}

TEST(Stiffness, BadRecordsAreOneSentenceWithTheirLine) {
  EXPECT_EQ(stiffness_complaint(record({800})),
            "test.csv:201: the force never exceeds the preload of 1000 N, its maximum is 800 N; give the test's own "
            "preload with --preload");
  EXPECT_NE(stiffness_complaint(record({6000}, 4))
                .find("a cycle has 3 points beyond the preload of 1000 N; a slope needs at least 5"),
            std::string::npos)
      << stiffness_complaint(record({6000}, 4));
  Curve slipped = record({6000});
  for (std::size_t p = 120; p < 125; ++p) slipped.y[p] -= 900;
  EXPECT_NE(stiffness_complaint(slipped).find("test.csv:122: the force falls from"), std::string::npos)
      << stiffness_complaint(slipped);
  Curve back = record({6000});
  back.x[150] -= 0.1e-3;
  EXPECT_NE(stiffness_complaint(back).find("test.csv:152: the displacement reverses by 0.09"), std::string::npos)
      << stiffness_complaint(back);
  Curve still = record({6000});
  for (double& x : still.x) x = 1e-3;
  EXPECT_NE(stiffness_complaint(still).find("does not change with the force"), std::string::npos);
  EXPECT_NE(stiffness_complaint(Curve{"test.csv", "", {}, {}, {}}).find("holds no points"), std::string::npos);
  Curve rising = record({6000}, 50);
  rising.x.resize(50), rising.y.resize(50);
  EXPECT_NE(stiffness_complaint(rising, {1000, identify::Branch::unloading}).find("the force never falls"),
            std::string::npos);
}

}  // namespace
