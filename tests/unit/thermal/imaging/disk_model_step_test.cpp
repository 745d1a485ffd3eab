#include "thermal/imaging/disk_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {
using arenite::imaging::BlurredStep;

TEST(BlurredStep, IsTheNormalDistributionWithItsDensity) {
  for (double u = -BlurredStep::reach; u <= BlurredStep::reach; u += 0.0037) {
    double density = 0;
    EXPECT_NEAR(BlurredStep::at(u, density), 0.5 * std::erfc(-u / std::numbers::sqrt2), 4e-9) << u;
    EXPECT_NEAR(density, std::exp(-0.5 * u * u) / std::sqrt(2 * std::numbers::pi), 2e-8) << u;
  }
  double density = 0;
  EXPECT_NEAR(BlurredStep::at(BlurredStep::reach, density), 1, 1e-6);  // the last point of the table
}

}  // namespace
