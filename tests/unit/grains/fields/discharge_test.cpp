#include "grains/fields/discharge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::fields {
namespace {

struct Record {
  std::vector<double> time, passed;
};

/// Grains of mass 2 pass one by one from `begin` to `end` at a rate that fluctuates from interval to interval about 500
/// 1/s; the rate comes up and dies away in 0.1 s.
Record record(std::uint64_t seed, double begin, double end, double spread) {
  RandomStream random(seed, Purpose::test);
  Record r;
  double amount = 0;
  for (int k = 0; k <= 1500; ++k) {
    const double t = 2e-3 * k;
    r.time.push_back(t);
    r.passed.push_back(2 * std::floor(amount));
    const double up = 1 - std::exp(-std::max(0.0, t - begin) / 0.02),
                 down = 1 - std::exp(-std::max(0.0, end - t) / 0.02);
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

/// `sum` of the masses of grains that have passed, each row added up anew, so that it jitters in its last bit; the last
/// grain passes at 0.9 s of 3.
Record emptied(bool jitters) {
  Record r;
  double whole = 0;
  for (int k = 0; k <= 1500; ++k) {
    const double t = 2e-3 * k;
    if (t > 0.2 && t < 0.9 && k % 3 == 0) whole += 9.5e-4;
    r.time.push_back(t);
    r.passed.push_back(whole * (1 + (jitters ? 4e-16 * (k * 7 % 5 - 2) : 0)));
  }
  return r;
}

TEST(Discharge, OfAHopperThatRanEmptyIsThatBeforeThoughSumsJitter) {
  const Record exact = emptied(false), jittering = emptied(true);
  const Discharge a = find_discharge(exact.time, exact.passed), b = find_discharge(jittering.time, jittering.passed);
  ASSERT_TRUE(a.steady);
  EXPECT_NEAR(a.rate.value, 9.5e-4 / 6e-3, 0.01 * 9.5e-4 / 6e-3);
  EXPECT_TRUE(b.steady);
  EXPECT_NEAR(b.rate.value, a.rate.value, 1e-9 * a.rate.value);
  EXPECT_NEAR(b.end, a.end, 1e-9);
  EXPECT_TRUE(a.stopped && b.stopped);
  const Record flowing = record(1, 0.3, 5, 0.5);
  EXPECT_FALSE(find_discharge(flowing.time, flowing.passed).stopped);
}

TEST(Discharge, OfAnEmptyHopperIsNoneThoughSumsJitter) {
  Record r = emptied(true);
  r.time.erase(r.time.begin(), r.time.begin() + 600);
  r.passed.erase(r.passed.begin(), r.passed.begin() + 600);
  EXPECT_TRUE(std::isnan(find_discharge(r.time, r.passed).rate.value));
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

TEST(NarrowestOpening, OfAConeIsItsLowerRim) {
  DomainIn<3> domain;
  BoundaryIn<3> cone;
  constexpr int faces = 64;
  const auto at = [&](double radius, double height, int k) {
    const double angle = 2 * std::numbers::pi * (k % faces) / faces;
    return Vec3{radius * std::cos(angle), height, radius * std::sin(angle)};
  };
  for (int k = 0; k < faces; ++k) {
    for (const Vec3& p : {at(0.02, 0, k), at(0.02, 0, k + 1), at(0.1, 0.1, k + 1), at(0.1, 0.1, k)})
      cone.points.push_back(p);
    cone.corners.push_back(4);
  }
  domain.boundaries.push_back(cone);
  EXPECT_NEAR(narrowest_opening(domain), 0.04 * std::cos(std::numbers::pi / faces), 1e-12);
  domain.boundaries[0].present = false;
  EXPECT_TRUE(std::isnan(narrowest_opening(domain)));
}

TEST(DischargeRate, IsThatOfTheLastTwentyGrainsAndFallsWhenNoneFollow) {
  std::vector<double> time, grains, mass;
  for (int k = 0; k < 400; ++k) {  // from 1 s to 3 s ten grains of 2 g pass a tenth of a second, then none
    time.push_back(0.01 * k);
    grains.push_back(std::clamp(k - 100, 0, 200));
    mass.push_back(2e-3 * grains.back());
  }
  const auto rate = discharge_rate(time, grains, grains), by_mass = discharge_rate(time, grains, mass);
  EXPECT_EQ(rate[50], 0);
  for (const std::size_t k : {101, 110, 200, 300}) EXPECT_NEAR(rate[k], 100, 1e-9) << k;
  EXPECT_NEAR(by_mass[200], 0.2, 1e-12);
  // Twenty grains in the 0.2 s before, none in the 0.8 s since.
  EXPECT_NEAR(rate[380], 20, 1e-9);
}

TEST(Discharge, OfASiloThatRunsEmptyIsThatBeforeItsStragglers) {
  std::vector<double> time, passed;
  for (int k = 0; k <= 1500; ++k) {
    time.push_back(1e-3 * k);
    passed.push_back(std::min(k, 400) * 1.0 + (k - 400) / 220 * (k > 400));
  }
  const Discharge found = find_discharge(time, passed);
  EXPECT_NEAR(found.rate.value, 1000, 20);
  EXPECT_LT(found.end, 0.41);
}

}  // namespace
}  // namespace arenite::fields
