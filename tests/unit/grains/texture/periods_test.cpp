#include "grains/texture/periods.hpp"

#include <gtest/gtest.h>

namespace arenite::texture {
namespace {

TEST(Periods, OfAxesAreHalfATurnAndOfModesAPart) {
  for (const char* name : {"fabric.theta_c_deg", "theta_n_deg", "fabric.load_axis_deg", "axis_of_compression_deg"})
    EXPECT_EQ(period_deg(name), 180) << name;
  EXPECT_EQ(period_deg("fabric.modes.6.phase_deg"), 60);
  EXPECT_EQ(period_deg("modes.12.phase_deg"), 30);
}

TEST(Periods, OfOtherNumbersAreNone) {
  for (const char* name : {"surface.angle_deg", "motion_deg", "fabric.theta_c_degree", "modes.x.phase_deg", "phase_deg",
                           "modes.0.phase_deg", "axis.angle_deg", ""})
    EXPECT_EQ(period_deg(name), 0) << name;
}

}  // namespace
}  // namespace arenite::texture
