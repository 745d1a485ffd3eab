#include "io/results/former_periods.hpp"

#include <gtest/gtest.h>

namespace arenite::io {
namespace {

TEST(FormerPeriods, OfAxesAreHalfATurnAndOfModesAPart) {
  for (const char* name : {"fabric.theta_c_deg", "theta_n_deg", "fabric.load_axis_deg", "axis_of_compression_deg"})
    EXPECT_EQ(former_period_deg(name), 180) << name;
  EXPECT_EQ(former_period_deg("fabric.modes.6.phase_deg"), 60);
  EXPECT_EQ(former_period_deg("modes.12.phase_deg"), 30);
}

TEST(FormerPeriods, OfOtherNumbersAreNone) {
  for (const char* name : {"surface.angle_deg", "motion_deg", "fabric.theta_c_degree", "modes.x.phase_deg", "phase_deg",
                           "modes.0.phase_deg", "axis.angle_deg", ""})
    EXPECT_EQ(former_period_deg(name), 0) << name;
}

}  // namespace
}  // namespace arenite::io
