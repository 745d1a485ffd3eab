#include "grains/fields/regime/coming_to_rest.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::fields {
namespace {

TEST(SettlingTime, IsShorterWithDragAndLongerForAStricterRest) {
  const double period = 8e-3;
  const double without = settling_time(period, 0, 1e-4);
  EXPECT_NEAR(without, 4.5 * period * std::log(1e4), 1e-12);
  EXPECT_LT(settling_time(period, 100, 1e-4), without);
  EXPECT_LT(without, settling_time(period, 0, 1e-5));
}

/// Half as dense as a packing without friction, 20 mm wide and 10 mm high.
Bulk loose() {
  Bulk bulk;
  bulk.density = 1400, bulk.solid_fraction = 0.42;
  bulk.width = 0.02, bulk.height = 0.01, bulk.thickness = 0.06;
  return bulk;
}

TEST(ClosingTime, IsThatOfTheLongestWayAtTheSpeedOfItsInertialNumber) {
  dem::Stage stage;
  stage.inertial_number = 1e-2;
  const Closing from_above{.along_y = true, .pressure = 1e5, .without_friction = true};
  Bulk bulk = loose();
  // The height halves: 5 mm at 2e-2 sqrt(1e5 Pa/588 kg/m^3).
  EXPECT_NEAR(closing_time(stage, from_above, bulk), 5e-3 / (2e-2 * std::sqrt(1e5 / 588)), 1e-12);
  EXPECT_NEAR(bulk.height, 0.005, 1e-12);
  EXPECT_EQ(bulk.width, 0.02);
  EXPECT_EQ(closing_time(stage, from_above, bulk), 0);  // it is dense now
}

TEST(ClosingTime, OfASampleThatNothingPressesIsNoneAndUnderItsWeightThatOfAFall) {
  dem::Stage stage;
  Bulk bulk = loose();
  EXPECT_EQ(closing_time(stage, Closing{}, bulk), 0);
  stage.gravity = true;
  stage.gravity_size = 9.81;
  EXPECT_NEAR(closing_time(stage, Closing{.without_friction = true}, bulk), std::sqrt(5e-3 / 9.81), 1e-12);
}

}  // namespace
}  // namespace arenite::fields
