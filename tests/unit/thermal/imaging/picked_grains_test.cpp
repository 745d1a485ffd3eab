#include "thermal/imaging/picked_grains.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace arenite::imaging {
namespace {

PictureGrains circles(std::vector<Vec2> centre, double radius) {
  PictureGrains grains;
  grains.radius.assign(centre.size(), radius);
  grains.centre = std::move(centre);
  return grains;
}

TEST(PickedGrains, LieInTheContainer) {
  const FilmPlace place{{0, 0.1}, 1e-3};  // 100 x 100 pixels of 1 mm
  PictureGrains grains = circles({{50, 50}, {4, 50}, {50, 104}, {96, 4}}, 6);
  keep_inside({0.1, 0.1}, place, grains);  // a middle by more than half of its radius, 3 pixels
  EXPECT_EQ(grains.centre, (std::vector<Vec2>{{50, 50}, {4, 50}, {96, 4}}));
  EXPECT_EQ(grains.radius.size(), 3u);
}

TEST(PickedGrains, OfTwoThatOverlapTheOneWithLessOfARimGoes) {
  PictureGrains grains = circles({{10, 10}, {17, 10}, {40, 10}, {49, 10}}, 5);  // by 3 and by 1; load presses to 1.5
  grains.score = {0.4, 0.9, 0.4, 0.9};
  drop_overlapping(grains);
  EXPECT_EQ(grains.centre, (std::vector<Vec2>{{17, 10}, {40, 10}, {49, 10}}));
}

TEST(PickedGrains, PoresAreAsDarkAsWhatIsBehind) {
  std::vector<float> frame(1000, 1);
  for (std::size_t k = 0; k < 200; ++k) frame[k] = 0;
  PictureGrains grains = circles({{1, 1}, {2, 2}, {3, 3}}, 1);
  grains.brightness = {1, 0.1, 1};
  drop_pores(frame, true, grains);
  EXPECT_EQ(grains.centre, (std::vector<Vec2>{{1, 1}, {3, 3}}));
}

TEST(PickedGrains, CoverTheContainerByTheirDisks) {
  const FilmPlace place{{0, 0.1}, 1e-3};
  std::vector<Vec2> centres;  // disks that touch on a square lattice cover pi/4
  for (int k = 0; k < 100; ++k) centres.push_back({5.0 + 10 * (k % 10), 5.0 + 10 * (k / 10)});
  EXPECT_NEAR(covered_share({0.1, 0.1}, place, circles(centres, 5)), std::numbers::pi / 4, 1e-12);
  EXPECT_LT(least_covered_share, std::numbers::pi / 4);
}

}  // namespace
}  // namespace arenite::imaging
