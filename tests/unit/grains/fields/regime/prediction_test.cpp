#include "grains/fields/regime/prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/run_stage.hpp"

namespace arenite::fields {
namespace {

using std::numbers::pi;

/// Two disks of POM, one of them larger, 60 mm long.
Packing two_disks(double radius, double larger) {
  Packing packing;
  packing.materials = {{"POM", 1410, 27.35e6, 0}};
  packing.domain.thickness = 0.06;
  packing.domain.wall[right].position = packing.domain.wall[top].position = 1;
  packing.grains.resize(2);
  packing.grains.radius = {radius, larger};
  packing.grains.position = {{0.3, 0.5}, {0.6, 0.5}};
  return packing;
}

TEST(Collision, OfTwoEqualDisksLastsHalfAPeriodOfTheirSpring) {
  const double mass = 1410 * pi * 0.005 * 0.005 * 0.06;
  EXPECT_NEAR(collision_time(mass / 2, 27.35e6), pi / std::sqrt(2 * 27.35e6 / mass), 1e-18);
  const auto shortest = shortest_collision(two_disks(0.005, 0.008), {});
  EXPECT_NEAR(shortest.time, collision_time(mass / 2, 27.35e6), 1e-15);
  EXPECT_EQ(shortest.radius, 0.005);
  EXPECT_FALSE(shortest.with_wall);
}

TEST(Steps, AreADurationOverTheStepRoundedUp) {
  EXPECT_EQ(dem::steps_of(0.5, 1e-3), 500);
  EXPECT_EQ(dem::steps_of(0.5004, 1e-3), 501);
}

TEST(InertialNumber, IsThatOfAHandCalculation) {
  EXPECT_NEAR(inertial_number(0.3, 0.008, 1200, 50e3), 0.0024 * std::sqrt(0.024), 1e-15);
  EXPECT_EQ(flow_regime(9e-4), "quasi-static");
  EXPECT_EQ(flow_regime(1e-3), "dense flow");
  EXPECT_EQ(flow_regime(0.1), "dense flow");
  EXPECT_EQ(flow_regime(0.11), "inertial");
}

TEST(StiffnessNumber, IsStiffnessOverPressureTimesLengthForALinearLaw) {
  EXPECT_NEAR(stiffness_number(dem::Linear{}, 1e6, 0.002, 0.01, 1e4), 1e4, 1e-6);
}

TEST(StiffnessNumber, GrowsAsThePressureToMinusTwoThirdsForHertz) {
  const double share = 1e4 * 0.01 / (2 * 1e6);  // P L/(2 k), for 1/R* = 4/d
  EXPECT_NEAR(stiffness_number(dem::Hertz{}, 1e6, 0.002, 0.01, 1e4) * std::pow(share, 2.0 / 3), 1, 1e-9);
}

TEST(Overlap, OfGrainsThatAreTooSoftIsTheirDiameter) { EXPECT_EQ(overlap_under(dem::Linear{}, 10, 0.01, 1e3), 0.01); }

}  // namespace
}  // namespace arenite::fields
