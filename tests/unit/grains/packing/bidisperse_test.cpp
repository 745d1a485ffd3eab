#include "grains/packing/bidisperse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "grains/packing/free_space.hpp"
#include "grains/packing/poisson_disk.hpp"
#include "grains/packing/two_classes.hpp"
#include "unit/grains/packing/classes.hpp"

namespace arenite::packing {
namespace {

using std::numbers::pi;

Packing box_with_sides(bool periodic_x, bool periodic_y) {
  Packing packing;
  packing.domain.periodic[0] = periodic_x;
  packing.domain.periodic[1] = periodic_y;
  return packing;
}

/// The smallest surface gap of any two grains in [from, to), and of any grain to a wall, by comparing all with all.
double smallest_gap(const Packing& p, std::size_t from, std::size_t to) {
  double least = INFINITY;
  const Grains& g = p.grains;
  for (std::size_t i = from; i < to; ++i) {
    for (std::size_t j = from; j < i; ++j)
      least = std::min(least, norm(p.domain.nearest_image(g.position[i] - g.position[j])) - g.radius[i] - g.radius[j]);
    if (p.domain.wall[left].present)
      least = std::min({least, g.position[i].x - g.radius[i], p.domain.width() - g.position[i].x - g.radius[i]});
    if (p.domain.wall[bottom].present)
      least = std::min({least, g.position[i].y - g.radius[i], p.domain.height() - g.position[i].y - g.radius[i]});
  }
  return least;
}

/// Where the room for one more disk of that radius would have a corner: circles of forbidden centres cross one another
/// or walls. Room that has no corner is a whole circle or the whole box, so no corner means no room (walls only).
std::size_t open_corners(const Packing& p, std::size_t grains, double radius, double gap) {
  const Grains& g = p.grains;
  const double side = p.domain.width(), slack = 1e-9 * radius;
  const auto is_open = [&](Vec2 q) {
    if (q.x < radius - slack || q.x > side - radius + slack || q.y < radius - slack || q.y > side - radius + slack)
      return false;
    for (std::size_t k = 0; k < grains; ++k) {
      const Vec2 d = q - g.position[k];
      const double reach = g.radius[k] + radius + gap - slack;
      if (dot(d, d) < reach * reach) return false;
    }
    return true;
  };
  std::size_t open = 0;
  for (std::size_t i = 0; i < grains; ++i) {
    const Vec2 c = g.position[i];
    const double r = g.radius[i] + radius + gap;
    for (const double wall : {radius, side - radius})
      for (const double sign : {-1.0, 1.0}) {
        if (std::abs(wall - c.x) < r)
          open += is_open({wall, c.y + sign * std::sqrt(r * r - (wall - c.x) * (wall - c.x))});
        if (std::abs(wall - c.y) < r)
          open += is_open({c.x + sign * std::sqrt(r * r - (wall - c.y) * (wall - c.y)), wall});
      }
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 d = g.position[j] - c;
      const double s = g.radius[j] + radius + gap, apart = norm(d);
      if (apart >= r + s || apart <= std::abs(r - s)) continue;
      const double along = (apart * apart + r * r - s * s) / (2 * apart),
                   across = std::sqrt(std::max(0.0, r * r - along * along));
      const Vec2 u = (1 / apart) * d;
      for (const double sign : {-1.0, 1.0}) open += is_open(c + along * u + sign * across * Vec2{-u.y, u.x});
    }
  }
  for (const double x : {radius, side - radius})
    for (const double y : {radius, side - radius}) open += is_open({x, y});
  return open;
}

class Sides : public testing::TestWithParam<std::tuple<bool, bool, bool>> {};

TEST_P(Sides, NoDisksOverlapAndLargeOnesKeepTheGap) {
  const auto [periodic_x, periodic_y, hold] = GetParam();
  Packing packing = box_with_sides(periodic_x, periodic_y);
  auto p = parameters(3.33, 1.6, 100);
  p.hold_radius = hold;
  const auto report = sample_bidisperse(packing, p, 7);
  ASSERT_EQ(report.large + report.small, packing.grains.size());
  EXPECT_GT(report.gap, 0.1 * p.large_radius);
  EXPECT_GE(smallest_gap(packing, 0, packing.grains.size()), -1e-12 * p.large_radius);
  Packing large = packing;
  for (int side = 0; side < 4; ++side) large.domain.wall[side].present = false;
  EXPECT_GE(smallest_gap(large, 0, report.large), report.gap - 1e-12 * p.large_radius);
  EXPECT_LT(smallest_gap(large, 0, report.large),
            report.gap + 1e-6 * p.large_radius);  // the gap is no wider than needed
  for (std::size_t i = 0; i < packing.grains.size(); ++i)
    EXPECT_EQ(packing.grains.material[i], i < report.large ? 0 : 1);
  EXPECT_NEAR(packing.domain.area(), 100 * pi * 1e-6, 1e-15);
  EXPECT_EQ(packing.domain.wall[left].present, !periodic_x);
  EXPECT_EQ(packing.domain.wall[top].present, !periodic_y);
}

INSTANTIATE_TEST_SUITE_P(Bidisperse, Sides, testing::Combine(testing::Bool(), testing::Bool(), testing::Bool()));

TEST(Bidisperse, LeavesNoRoomForTheSmallestDiskOfEitherClass) {
  Packing packing;
  auto p = parameters(2.5, 1.6, 80);
  p.maximal = true;
  const auto report = sample_bidisperse(packing, p, 3);
  ASSERT_EQ(report.left_out, 0u);
  const double least = 0.625 * p.large_radius;
  EXPECT_EQ(open_corners(packing, report.large, least * (1 + 1e-6), report.gap), 0u);
  EXPECT_EQ(open_corners(packing, packing.grains.size(), least / 2.5 * (1 + 1e-6), 0), 0u);
  EXPECT_GT(open_corners(packing, packing.grains.size(), least / 2.5 / 2, 0),
            100u);  // half that disk has room in many places

  p.maximal = false;  // what P does: the trials alone leave room
  const auto tried = sample_bidisperse(packing, p, 3);
  EXPECT_GT(open_corners(packing, packing.grains.size(), least / 2.5 * (1 + 1e-6), 0), 10u);
  EXPECT_LT(tried.solid_fraction, report.solid_fraction);
}

// The mean radii of an independent sampling of P's Appendix with 100 trials, which ends with them: 0.890 of the nominal
// small one. Filling all that is left afterwards gives 0.857.
TEST(Bidisperse, EndsWithTheTrialsAsThePaperDoes) {
  Packing packing;
  auto p = parameters(5, 1.4, 900);
  p.trials = 100;
  const auto report = sample_bidisperse(packing, p, 2);
  EXPECT_NEAR(report.mean_small * 5 / p.large_radius, 0.890, 0.008);
}

TEST(Bidisperse, HeldRadiiEndWithOneThatFitsNowhere) {
  const double side = 14;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    FreeSpace<2> space({{}, {side, side}}, 0.3);
    space.open_store(2);
    RandomStream random(seed, Purpose::test);
    const double refused = fill_holding(space, {1, 0.25, 0.625, 1.375}, random);
    const std::vector<Ball<2>>& disks = space.balls();
    Packing packing;
    packing.domain.wall[right].position = packing.domain.wall[top].position = side;
    packing.grains.resize(disks.size());
    for (std::size_t i = 0; i < disks.size(); ++i) {
      packing.grains.position[i] = disks[i].centre;
      packing.grains.radius[i] = disks[i].radius;
    }
    EXPECT_GT(disks.size(), 10u);
    EXPECT_EQ(open_corners(packing, disks.size(), refused * (1 + 1e-6), 0.3), 0u) << seed;
  }
}

TEST(Bidisperse, SameSeedSameBytesAndAnotherSeedAnotherSample) {
  Packing a, b, c;
  const auto p = parameters(2, 2.2);
  sample_bidisperse(a, p, 4);
  sample_bidisperse(b, p, 4);
  sample_bidisperse(c, p, 5);
  EXPECT_EQ(a.grains.position, b.grains.position);
  EXPECT_EQ(a.grains.radius, b.grains.radius);
  EXPECT_NE(a.grains.position, c.grains.position);
}

TEST(Bidisperse, SmallDisksAreLeftOutByLot) {
  TwoClasses<2> classes;
  classes.large = 1;
  classes.balls.assign(2001, Ball<2>{{0, 0}, 1});
  for (std::size_t i = 1; i <= 2000; ++i) classes.balls[i].centre.x = i <= 1000 ? -1 : 1;
  classes.volume_large = 1000 * pi;
  classes.volume_small = 2000 * pi;
  EXPECT_EQ(leave_out_small(classes, 1, 9), 1000u);
  EXPECT_EQ(classes.balls.size(), 1001u);
  EXPECT_NEAR(classes.volume_ratio(), 1, 1e-9);
  const auto first_half =
      std::count_if(classes.balls.begin() + 1, classes.balls.end(), [](const Ball<2>& d) { return d.centre.x < 0; });
  EXPECT_NEAR(static_cast<double>(first_half), 500, 45);  // four deviations of a fair draw without return
}

}  // namespace
}  // namespace arenite::packing
