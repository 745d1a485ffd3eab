#include "thermal/thermography/grains/grain_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "thermal/thermography/grains/follow_grains.hpp"

namespace arenite::thermography {
namespace {

/// Two grains of which the first moves to and fro along x by 3 pixels and the second along y by 1, largest at `phase`.
GrainMotion to_and_fro(double phase) {
  GrainMotion motion;
  for (const Vec2 amplitude : {Vec2{1.5, 0}, Vec2{0, -0.5}}) {
    motion.cosine.push_back(std::cos(phase) * amplitude);
    motion.sine.push_back(std::sin(phase) * amplitude);
    motion.error.push_back(0.1);
  }
  return motion;
}

TEST(GrainPlaces, GrainsGoAllOfTheirWayUpToTheLargestLoad) {
  PictureGrains found;
  found.centre = {{10, 20}, {30, 40}};
  found.radius = {5, 6};
  for (const double phase : {0.0, 0.7, 2.5, -1.9}) {
    const PictureGrains largest = moved(found, to_and_fro(phase), phase, 1),
                        middle = moved(found, to_and_fro(phase), phase, 0.5);
    EXPECT_NEAR(largest.centre[0].x, 13, 1e-12);
    EXPECT_NEAR(largest.centre[1].y, 39, 1e-12);
    EXPECT_NEAR(middle.centre[0].x, 11.5, 1e-12);
    EXPECT_NEAR(middle.centre[1].y, 39.5, 1e-12);
    EXPECT_EQ(middle.radius, found.radius);
  }
}

TEST(GrainPlaces, BetweenAWallThatTravelsAndOneThatRestsTheSampleIsStrainedEvenly) {
  const double travel = 8, phase = 1.1;
  const std::vector<double> height{0, 0.25, 1};
  const GrainMotion motion = motion_with_wall(height, travel, phase);
  PictureGrains found;
  found.centre = {{0, 100}, {0, 75}, {0, 0}};
  found.radius = {1, 1, 1};
  const PictureGrains loaded = moved(found, motion, phase, 1);
  // u_y = -travel (1 - y/H) in a picture whose rows point down
  EXPECT_NEAR(loaded.centre[0].y, 92, 1e-12);
  EXPECT_NEAR(loaded.centre[1].y, 69, 1e-12);
  EXPECT_NEAR(loaded.centre[2].y, 0, 1e-12);
  EXPECT_NEAR(motion.error[0], 0.5, 1e-12);  // a tenth of a pixel and of the amplitude of 4
  EXPECT_NEAR(motion.error[2], 0.1, 1e-12);
}

TEST(GrainPlaces, ErrorsOfAPlaceAndOfTheWayAddUpInSquares) {
  PictureGrains found;
  found.centre = {{0, 0}, {9, 0}};
  found.position_error = {0.3, 0.3};
  GrainMotion motion = to_and_fro(0);
  motion.error = {0.2, INFINITY};
  const PictureGrains loaded = with_errors_of_way(found, motion);
  // 0.3 beside the 0.4 of twice an amplitude and what sampling loses of the way.
  const double sampled = 0.006 * motion.travel(0);
  EXPECT_DOUBLE_EQ(loaded.position_error[0], std::sqrt(0.3 * 0.3 + 0.4 * 0.4 + sampled * sampled));
  EXPECT_EQ(loaded.position_error[1], 0.3);  // of a grain whose rim nobody saw nothing is known
}

TEST(GrainPlaces, LostGrainsHaveNoStress) {
  GrainMotion motion;
  motion.cosine.resize(5), motion.sine.resize(5);
  motion.error = {0.01, 0.011, 0.3, 0.009, 0.01};
  PeakToPeak change{std::vector<double>(5, 0.02), std::vector<double>(5, -1e6), std::vector<double>(5, 1e4), {}};
  EXPECT_EQ(forget_lost(motion, change), 1u);
  EXPECT_TRUE(std::isnan(change.sigma_hyd[2]) && std::isnan(change.temperature[2]) && std::isinf(change.error[2]));
  EXPECT_EQ(change.sigma_hyd[1], -1e6);
  EXPECT_EQ(change.error[3], 1e4);
}

/// A row of grains, 0.2 pixels apart, that go to and fro across it, each a little otherwise. Three are lost: one is
/// said to go into its neighbour, one far across the row where nobody is, one as the others do.
TEST(GrainPlaces, LostGrainsGoWhereNoOtherIs) {
  PictureGrains found;
  GrainMotion motion;
  for (int i = 0; i < 30; ++i) {
    found.centre.push_back({10.2 * i, 0});
    found.radius.push_back(5);
    motion.cosine.push_back({0.03 * (i % 3 - 1), 1 + 0.05 * (i % 2)});
    motion.sine.push_back({0, 0});
    motion.error.push_back(0.004);
  }
  const GrainMotion seen = motion;
  motion.error[8] = motion.error[12] = motion.error[20] = 0.05;
  motion.cosine[8] = {0, -4}, motion.cosine[12] = {1.5, 1};
  const std::vector<double> error = settle_lost(found, 0, motion);
  EXPECT_EQ(motion.cosine[8].y, -4);
  EXPECT_NEAR(motion.cosine[12].x, 0, 0.02);  // the mean of those beside it
  EXPECT_NEAR(motion.cosine[12].y, 1.025, 0.02);
  EXPECT_EQ(motion.cosine[20].y, seen.cosine[20].y);
  EXPECT_EQ(motion.cosine[5].y, seen.cosine[5].y);
  ASSERT_EQ(error.size(), 30u);
  EXPECT_EQ(error[5], 0);
  // Of a way that is twice the amplitude, and 0.6 % of its 8 pixels.
  EXPECT_DOUBLE_EQ(error[8], std::hypot(0.1, 0.006 * 8));
  // Amplitudes of neighbours differ by 0.025 and up to 0.03 along the axes.
  EXPECT_GT(error[12], 0.03);
  EXPECT_LT(error[12], 0.12);
  EXPECT_EQ(lost_grains(motion)[12], 1);
  motion = seen;
  EXPECT_TRUE(settle_lost(found, 0, motion).empty());
}

}  // namespace
}  // namespace arenite::thermography
