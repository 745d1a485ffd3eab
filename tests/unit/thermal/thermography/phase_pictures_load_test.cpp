#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {
namespace {

TEST(PhasePictures, TheSmallestLoadIsHalfACycleFromTheLargest) {
  PhasePictures pictures;  // every 30 degrees
  for (int k = 0; k < 12; ++k) {
    const double phase = k * std::numbers::pi / 6;
    pictures.frames.push_back(4);
    pictures.phases.push_back({1, std::cos(phase), std::sin(phase), 0, 0});
  }
  const auto degrees = [](double d) { return d * std::numbers::pi / 180; };
  EXPECT_EQ(picture_at_smallest_load(pictures, 0), 6u);
  EXPECT_EQ(picture_at_smallest_load(pictures, degrees(130)), 10u);  // 310 is nearest to 300
  EXPECT_EQ(picture_at_smallest_load(pictures, degrees(-140)), 1u);  // 40 to 30
}

TEST(PhasePictures, OppositePhasesAreHalfACycleApart) {
  for (const double phase : {-3.0, -1.0, 0.0, 0.4, 2.9}) {
    EXPECT_NEAR(std::cos(opposite(phase)), -std::cos(phase), 1e-15);
    EXPECT_NEAR(std::sin(opposite(phase)), -std::sin(phase), 1e-15);
    EXPECT_LE(std::abs(opposite(phase)), std::numbers::pi);
    EXPECT_TRUE(are_opposite(phase, opposite(phase) + 1.5));
    EXPECT_FALSE(are_opposite(phase, phase + 1.5));  // less than a quarter of a cycle, 1.57
    EXPECT_TRUE(are_opposite(phase, phase - 1.6));
  }
}

}  // namespace
}  // namespace arenite::thermography
