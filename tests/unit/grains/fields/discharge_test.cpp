#include "grains/fields/discharge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::fields {
namespace {

struct Record {
  std::vector<double> time, passed;
};

/// Grains of mass 2 pass one by one from `begin` to `end` at a rate that fluctuates from interval to interval about 500 1/s; the rate comes up and dies
/// away in 0.1 s.
Record record(std::uint64_t seed, double begin, double end, double spread) {
  RandomStream random(seed, Purpose::test);
  Record r;
  double amount = 0;
  for (int k = 0; k <= 1500; ++k) {
    const double t = 2e-3 * k;
    r.time.push_back(t);
    r.passed.push_back(2 * std::floor(amount));
    const double up = 1 - std::exp(-std::max(0.0, t - begin) / 0.02), down = 1 - std::exp(-std::max(0.0, end - t) / 0.02);
    if (t > begin && t < end) amount += 2e-3 * 500 * up * down * std::max(0.0, 1 + spread * random.normal());
  }
  return r;
}

TEST(Discharge, IsTheRateOfItsSteadyPartWithAnErrorThatCoversIt) {
  int covered = 0, steady = 0;
  const int series = 60;
  for (int k = 0; k < series; ++k) {
    const Record r = record(static_cast<std::uint64_t>(k), 0.3, 2.5, 0.5);
    const Discharge d = find_discharge(r.time, r.passed);
    if (!d.steady) continue;
    ++steady;
    EXPECT_GT(d.begin, 0.3);
    EXPECT_LT(d.end, 2.5);
    EXPECT_GT(d.end - d.begin, 0.5);
    EXPECT_NEAR(d.rate.value, 1000, 100) << k;
    EXPECT_LT(d.rate.error, 30);
    const auto interval = statistics::confidence_95(d.rate);
    covered += interval.low <= 1000 && 1000 <= interval.high;
  }
  EXPECT_GT(steady, 0.9 * series);
  EXPECT_GT(covered, 0.85 * steady);
}

TEST(Discharge, HasNoErrorWhereItNeverIsSteadyAndNoRateWhereNothingPasses) {
  std::vector<double> time, faster, nothing;
  for (int k = 0; k <= 400; ++k) {
    time.push_back(k);
    faster.push_back(k * k);
    nothing.push_back(7);
  }
  const Discharge d = find_discharge(time, faster);
  EXPECT_FALSE(d.steady);
  EXPECT_NEAR(d.rate.value, 400, 2);
  EXPECT_TRUE(std::isnan(d.rate.error));
  EXPECT_TRUE(std::isnan(find_discharge(time, nothing).rate.value));
  EXPECT_TRUE(std::isnan(find_discharge({}, {}).rate.value));
}

TEST(Discharge, RefusesRowsThatMakeNoSense) {
  EXPECT_THROW(find_discharge({0, 1}, {0}), InputError);
  EXPECT_THROW(find_discharge({0, 1, 1}, {0, 1, 2}), InputError);
  EXPECT_THROW(find_discharge({0, 1}, {0, std::numeric_limits<double>::infinity()}), InputError);
}

TEST(NarrowestOpening, IsTheWayBetweenBoundariesThatAreThere) {
  Domain domain;
  const auto add = [&](std::vector<Vec2> points, bool present) {
    Boundary b;
    b.points = std::move(points);
    b.present = present;
    domain.boundaries.push_back(b);
  };
  EXPECT_TRUE(std::isnan(narrowest_opening(domain)));
  add({{0, 0.1}, {0.05, 0.05}}, true);
  add({{0.2, 0.1}, {0.09, 0.05}, {0.09, 0}}, true);
  add({{0.04, 0.049}, {0.1, 0.049}}, false);
  EXPECT_NEAR(narrowest_opening(domain), 0.04, 1e-15);
  domain.boundaries[2].present = true;
  EXPECT_NEAR(narrowest_opening(domain), 0.001, 1e-15);
}

}  // namespace
}  // namespace arenite::fields
