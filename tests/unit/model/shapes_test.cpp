#include "model/shapes.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "geometry/rim.hpp"

namespace arenite {
namespace {

using std::numbers::pi;

/// A disk, a square widened by 0.1 and two disks that overlap, turned by these angles.
Grains three_grains(const std::vector<double>& angles) {
  Grains grains;
  grains.resize(3);
  grains.position = {{0, 0}, {5, 1}, {10, 2}};
  grains.radius = {1, 1, 1};
  grains.angle = angles;
  add_shape(grains.shapes, {{{0, 0}}, {1}, false}, std::sqrt(0.5));
  add_shape(grains.shapes, {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, {0.1, 0.1, 0.1, 0.1}, true}, 1);
  add_shape(grains.shapes, {{{-0.5, 0}, {0.5, 0}}, {0.7, 0.7}, false}, 1);
  return grains;
}

double area_within(const std::vector<Vec2>& loop) {
  double area = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) area += 0.5 * cross(loop[k], loop[(k + 1) % loop.size()]);
  return area;
}

TEST(Outlines, OfGrainsAsTheyLieHaveTheAreaOfTheirShapes) {
  const Grains grains = three_grains({0.3, pi / 4, 1.1});
  for (std::size_t g = 0; g < 3; ++g) {
    const double area = geometry::moments_within(rim_of(shape_of(grains, g))).area;
    EXPECT_NEAR(area_within(outline_of(grains, g, 0.01)), area, 2e-5 * area) << g;
    EXPECT_LT(area_within(outline_of(grains, g, 0.5)), (1 - 1e-4) * area) << g;  // chords of arcs lie inside
  }
}

TEST(Outlines, TurnWithTheirGrain) {
  const auto highest = [](const std::vector<Vec2>& loop) {
    double y = loop.front().y;
    for (const Vec2& p : loop) y = std::max(y, p.y);
    return y;
  };
  EXPECT_NEAR(highest(outline_of(three_grains({0, 0, 0}), 1)), 1 + 1.1, 1e-14);
  EXPECT_NEAR(highest(outline_of(three_grains({0, pi / 4, 0}), 1, 0.001)), 1 + std::sqrt(2.0) + 0.1, 1e-6);
  EXPECT_NEAR(highest(outline_of(three_grains({0, 0, pi / 2}), 2, 0.001)), 2 + 1.2, 1e-6);
}

TEST(Outlines, OfADiskAmongDisksNeedNoShapes) {
  Grains grains;
  grains.resize(1);
  grains.position = {{3, 4}}, grains.radius = {2};
  for (const Vec2& p : outline_of(grains, 0)) EXPECT_NEAR(norm(p - Vec2{3, 4}), 2, 1e-14);
}

TEST(Directions, AreCosineAndSineAtAnyAngle) {
  for (double angle = -50; angle < 50; angle += 0.37) {
    EXPECT_NEAR(direction(angle).x, std::cos(angle), 1e-14) << angle;
    EXPECT_NEAR(direction(angle).y, std::sin(angle), 1e-14) << angle;
  }
  EXPECT_EQ(direction(0), (Vec2{1, 0}));
}

}  // namespace
}  // namespace arenite
