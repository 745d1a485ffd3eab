#include "thermal/imaging/fitted_walls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace arenite::imaging {
namespace {

constexpr double pixel = 1.5e-3, radius = 6e-3, rim_error = 0.08 * pixel, reach = 3 * pixel;

/// A container of 0.1 x 0.1 m with eight grains along each of its left and right sides, of which every other one
/// touches; the others are up to a radius away.
Packing sample(double off = 0) {
  Packing p;
  p.domain.wall[right].position = p.domain.wall[top].position = 0.1;
  RandomStream random(5, Purpose::test, 31);
  p.grains.resize(16);
  for (std::size_t g = 0; g < 16; ++g) {
    const double gap = g % 4 < 2 ? 0.04 * pixel * random.normal() : random.uniform(0.3 * pixel, radius);
    const double y = 0.01 + 0.011 * static_cast<double>(g / 2);
    p.grains.radius[g] = radius;
    p.grains.position[g] = {off + (g % 2 == 0 ? radius + gap : 0.1 - radius - gap), y};
  }
  return p;
}

FittedWall fitted(const Packing& p, int side) {
  return fit_walls(p.grains, p.domain, rim_error, reach)[static_cast<std::size_t>(side)];
}

TEST(FittedWalls, AreWhereRimsTouchThem) {
  for (const double pixels : {-1.2, -0.6, 0.0, 0.6, 1.2}) {
    const Packing p = sample(pixels * pixel);
    const FittedWall a = fitted(p, left), b = fitted(p, right);
    EXPECT_EQ(a.touching, 4u);
    EXPECT_NEAR(a.shift, pixels * pixel, 4 * a.error) << pixels;
    EXPECT_NEAR(b.shift, -pixels * pixel, 4 * b.error) << pixels;  // inwards counts as positive
    EXPECT_LT(a.error, 0.06 * pixel);
  }
}

TEST(FittedWalls, OneCircleThatSticksOutIsNoWall) {
  Packing p = sample();
  p.grains.position[2].x -= 0.8 * pixel;
  EXPECT_NEAR(fitted(p, left).shift, 0, 0.1 * pixel);
}

TEST(FittedWalls, SidesThatNothingTouchesAreNotKnown) {
  const Packing p = sample();
  const auto walls = fit_walls(p.grains, p.domain, rim_error, reach);
  EXPECT_FALSE(walls[top].known());
  Domain open = p.domain;
  open.wall[left].present = false;
  EXPECT_FALSE(fit_walls(p.grains, open, rim_error, reach)[left].known());
}

TEST(FittedWalls, MoveTheContainersSides) {
  BySide<FittedWall> walls{};
  walls[left] = {0.002, 1e-4, 3}, walls[right] = {0.001, 1e-4, 3}, walls[top] = {0.005, 1e-4, 1};
  const Domain moved = with_fitted_walls(sample().domain, walls);
  EXPECT_DOUBLE_EQ(moved.wall[left].position, 0.002);
  EXPECT_DOUBLE_EQ(moved.wall[right].position, 0.099);
  EXPECT_DOUBLE_EQ(moved.wall[top].position, 0.1);  // one grain is not enough
}

}  // namespace
}  // namespace arenite::imaging
