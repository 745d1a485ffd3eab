#include "grains/packing/room.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "grains/packing/population.hpp"

namespace arenite::packing {
namespace {

TEST(Room, SharesAreAreasOfCirclesOverTheArea) {
  // Ten squares of side 2: circles of radius sqrt(2), grains of area 4.
  const std::vector<double> circles(10, std::sqrt(2.0)), own(10, std::sqrt(4 / std::numbers::pi));
  const Room tight = room_in(50, circles, own);
  EXPECT_NEAR(tight.circles, 20 * std::numbers::pi / 50, 1e-12);
  EXPECT_NEAR(tight.grains, 0.8, 1e-12);
  EXPECT_FALSE(tight.suffices());
  // As much larger as it says, and at the solid fraction that it says, there is just room.
  const Room enough = room_in(50 * tight.times_larger(), circles, own);
  EXPECT_NEAR(enough.circles, Room::most, 1e-12);
  EXPECT_NEAR(enough.grains, tight.solid_fraction(), 1e-12);
  EXPECT_TRUE(room_in(51 * tight.times_larger(), circles, own).suffices());
}

TEST(Room, GrainsAreCirclesForAWhileOnly) {
  Population p;
  p.material = "A";
  p.count = 20;
  p.size = UniformSizes{1e-3, 2e-3};
  Grains grains = draw_grains({p}, {{"A", 1000, 1e6, 0}}, 0, 1);
  const auto before = grains.radius;
  {
    const Circles circles(grains);
    EXPECT_EQ(circles.own_radii(), before);
    EXPECT_EQ(grains.radius, circle_radii(grains));
  }
  EXPECT_EQ(grains.radius, before);
}

}  // namespace
}  // namespace arenite::packing
