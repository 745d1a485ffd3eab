#include <gtest/gtest.h>

#include <numbers>

#include "geometry/outline.hpp"
#include "geometry/rim.hpp"

namespace arenite::geometry {
namespace {

using std::numbers::pi;

double length_of(const std::vector<Edge>& rim) {
  double length = 0;
  for (const Edge& edge : rim) length += edge.straight() ? norm(edge.b - edge.a) : edge.radius * std::abs(edge.sweep);
  return length;
}

/// How often the loop of a rim begins anew instead of going on where the edge before ended.
int breaks(const std::vector<Edge>& rim) {
  int count = 0;
  for (std::size_t k = 0; k < rim.size(); ++k)
    if (norm(rim[k].b - rim[(k + 1) % rim.size()].a) > 1e-12) ++count;
  return count;
}

TEST(RimOfAPolygon, HasSidesAndArcsByTurnsThatGoOnSmoothly) {
  const std::vector<Vec2> corners{{0, 0}, {4, 0}, {0, 3}};
  const double r = 0.5;
  const auto rim = rim_of_polygon(corners, r);
  ASSERT_EQ(rim.size(), 6U);
  double turn = 0;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    EXPECT_EQ(rim[k].straight(), k % 2 == 0);
    EXPECT_LT(norm(rim[k].outward(1) - rim[(k + 1) % rim.size()].outward(0)), 1e-14);
    if (!rim[k].straight()) turn += rim[k].sweep;
  }
  EXPECT_EQ(breaks(rim), 0);
  EXPECT_NEAR(turn, 2 * pi, 1e-14);
  // The side from (4, 0) to (0, 3), pushed out along its normal (0.6, 0.8).
  EXPECT_LT(norm(rim[2].a - Vec2{4.3, 0.4}), 1e-14);
  EXPECT_LT(norm(rim[2].b - Vec2{0.3, 3.4}), 1e-14);
  EXPECT_NEAR(length_of(rim), 12 + 2 * pi * r, 1e-13);  // Steiner's formulas of a parallel body
  EXPECT_NEAR(moments_within(rim).area, 6 + 12 * r + pi * r * r, 1e-13);
}

TEST(RimOfDisks, LeavesOutWhatOtherDisksCover) {
  const double d = 1.2, half = std::acos(d / 2), lens = 2 * (half - std::sin(half) * std::cos(half));
  const auto rim = rim_of_disks({{0, 0}, {d, 0}}, {1, 1});
  EXPECT_NEAR(length_of(rim), 2 * (2 * pi - 2 * half), 1e-12);
  EXPECT_NEAR(moments_within(rim).area, 2 * pi - lens, 1e-12);
  EXPECT_LT(norm(moments_within(rim).centre - Vec2{d / 2, 0}), 1e-12);
  EXPECT_EQ(breaks(rim), 0);
}

TEST(RimOfDisks, OfADiskWithinAnotherAndOfTwoThatCoincideIsThatOfOne) {
  for (const auto& [centre, radius] : {std::pair{std::vector<Vec2>{{0, 0}, {0.2, 0.1}}, std::vector<double>{1, 0.5}},
                                       std::pair{std::vector<Vec2>{{0, 0}, {0, 0}}, std::vector<double>{1, 1}}}) {
    EXPECT_NEAR(length_of(rim_of_disks(centre, radius)), 2 * pi, 1e-12);
    EXPECT_NEAR(moments_within(rim_of_disks(centre, radius)).area, pi, 1e-12);
  }
}

TEST(RimOfDisks, GoesRoundAHoleTheOtherWay) {
  const auto rim = rim_of_disks({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, {1.1, 1.1, 1.1, 1.1});
  EXPECT_EQ(breaks(rim), 2);  // two loops
  const double half = std::acos(1 / 1.1), lens = 2 * 1.1 * 1.1 * (half - std::sin(half) * std::cos(half));
  EXPECT_NEAR(moments_within(rim).area, 4 * pi * 1.1 * 1.1 - 4 * lens, 1e-12);
}

}  // namespace
}  // namespace arenite::geometry
