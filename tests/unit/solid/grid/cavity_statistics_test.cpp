#include "solid/grid/cavities.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "solid/grid/cavity_statistics.hpp"

namespace arenite::grid {
namespace {

Cavities with_nodes(std::vector<std::int64_t> nodes) {
  Cavities cavities;
  cavities.nodes = std::move(nodes);
  return cavities;
}

TEST(CavityStatistics, AreThoseOfTheVolumesOverTheLargeGrains) {
  const auto s = cavity_statistics(with_nodes({10, 20, 60}), 0.5, 2);
  const double unit = 0.25 / (4 * std::numbers::pi);
  EXPECT_EQ(s.count, 3u);
  EXPECT_NEAR(s.mean.value, 30 * unit, 1e-15);
  EXPECT_NEAR(s.deviation.value, std::sqrt(700.0) * unit, 1e-15);
  EXPECT_NEAR(s.cv.value, std::sqrt(700.0) / 30, 1e-14);
  EXPECT_NEAR(s.mean.error, s.deviation.value / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(s.tenth, 10 * unit, 1e-15);
  EXPECT_NEAR(s.median, 20 * unit, 1e-15);
}

TEST(CavityStatistics, OfNoneOneOrEqualOnesAreFinite) {
  for (const auto& nodes : {std::vector<std::int64_t>{}, {7}, {7, 7, 7}}) {
    const auto s = cavity_statistics(with_nodes(nodes), 1, 1);
    EXPECT_EQ(s.deviation.value, 0);
    EXPECT_EQ(s.cv.error, 0);
    EXPECT_EQ(s.density.count.empty(), nodes.empty());
  }
}

RC_GTEST_PROP(CavityStatistics, DensityCountsEveryCavityOnceAndIntegratesToOne, ()) {
  const auto nodes =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<std::int64_t>>(rc::gen::inRange<std::int64_t>(1, 4000)));
  const auto pdf = cavity_statistics(with_nodes(nodes), 0.1, 1.5).density;
  RC_ASSERT(pdf.edge.size() == pdf.count.size() + 1);
  RC_ASSERT(static_cast<int>(pdf.count.size()) <= 30);
  RC_ASSERT(std::accumulate(pdf.count.begin(), pdf.count.end(), std::size_t{0}) == nodes.size());
  double integral = 0;
  for (std::size_t k = 0; k < pdf.count.size(); ++k) {
    RC_ASSERT(pdf.edge[k + 1] > pdf.edge[k]);
    integral += pdf.density[k] * (pdf.edge[k + 1] - pdf.edge[k]);
  }
  RC_ASSERT(std::abs(integral - 1) < 1e-12);
}

TEST(CavityStatistics, ErrorsAreThoseSeenOverManySamples) {
  // Skewed volumes, so that the covariance of mean and deviation counts; bounded, as heavy tails need far more of them
  // before their fourth moment is seen.
  const int samples = 600, n = 400;
  double sum[3] = {0, 0, 0}, square[3] = {0, 0, 0}, predicted[3] = {0, 0, 0};
  RandomStream random(5, Purpose::test);
  for (int s = 0; s < samples; ++s) {
    std::vector<std::int64_t> nodes;
    for (int k = 0; k < n; ++k) nodes.push_back(5 + static_cast<std::int64_t>(900 * std::pow(random.uniform(), 2)));
    const auto found = cavity_statistics(with_nodes(nodes), 1, 1);
    const double value[3] = {found.mean.value, found.deviation.value, found.cv.value};
    const double error[3] = {found.mean.error, found.deviation.error, found.cv.error};
    for (int k = 0; k < 3; ++k)
      sum[k] += value[k], square[k] += value[k] * value[k], predicted[k] += error[k] / samples;
  }
  for (int k = 0; k < 3; ++k) {
    const double mean = sum[k] / samples, seen = std::sqrt(square[k] / samples - mean * mean);
    EXPECT_NEAR(predicted[k] / seen, 1, 0.09) << k;
  }
}

TEST(CavityStatistics, BadInputIsNamed) {
  EXPECT_THROW(cavity_statistics({}, 0, 1), InputError);
  EXPECT_THROW(cavity_statistics({}, 1, -1), InputError);
  EXPECT_THROW(cavity_statistics({}, 1, INFINITY), InputError);
}

TEST(PhaseFractions, AreSharesOfNodes) {
  PhaseMap map = make_phase_map(5, 2, 1);
  map.grain_class = {GrainClass::large, GrainClass::small};
  for (int k = 0; k < 5; ++k) map.phase[k] = Phase::particle, map.grain[k] = k < 3 ? 0 : 1;
  map.phase[5] = Phase::matrix;
  const PhaseFractions f = phase_fractions(map);
  EXPECT_EQ(f.particle, 0.5);
  EXPECT_EQ(f.large, 0.3);
  EXPECT_EQ(f.small, 0.2);
  EXPECT_EQ(f.matrix, 0.1);
  EXPECT_EQ(f.empty, 0.4);
  EXPECT_EQ(f.saturation, 0.2);
  EXPECT_EQ(fractions_by_kind(map), (std::array<double, 5>{0.4, 0.1, 0, 0.2, 0.3}));
  EXPECT_EQ(phase_fractions(make_phase_map(3, 3, 1)).saturation, 0);
}

std::vector<double> lognormal(double median, double spread, std::size_t n) {
  RandomStream random(5, Purpose::test);
  std::vector<double> volumes;
  for (std::size_t k = 0; k < n; ++k) volumes.push_back(median * std::exp(spread * random.normal()));
  return volumes;
}

TEST(DensityPeak, OfLogNormalVolumesIsTheirMode) {
  // The mode is exp(m - s^2); the kernel's width w makes s^2 + w^2 of s^2, 4 % more here.
  EXPECT_NEAR(density_peak(lognormal(0.3, 0.5, 20000)), 0.3 * std::exp(-0.25), 0.015);
}

TEST(DensityPeak, GrowsWithTheUnit) {
  auto volumes = lognormal(1, 0.7, 300);
  const double peak = density_peak(volumes);
  for (double& v : volumes) v *= 3;
  EXPECT_NEAR(density_peak(volumes), 3 * peak, 1e-12);
}

TEST(DensityPeak, OfOneOrEqualVolumesIsUnknown) {
  EXPECT_TRUE(std::isnan(density_peak({})));
  EXPECT_TRUE(std::isnan(density_peak({2})));
  EXPECT_TRUE(std::isnan(density_peak({2, 2, 2})));
}

}  // namespace
}  // namespace arenite::grid
