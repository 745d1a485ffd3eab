#include "solid/raster/volume_peak.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace arenite::raster {
namespace {

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
}  // namespace arenite::raster
