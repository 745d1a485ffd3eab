#include "geometry/rectangle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/union_area.hpp"

namespace arenite::geometry {
namespace {

using std::numbers::pi;

/// Height of the window that the disk covers at x, integrated by the midpoint rule after x = sin(u), which takes the
/// square roots at the rim away.
double by_quadrature(Vec2 c, double r, const Rectangle& w) {
  const int n = 20000;
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    const double u = -pi / 2 + pi * (k + 0.5) / n;
    const double x = c.x + r * std::sin(u), half = r * std::cos(u);
    if (x < w.x_min || x > w.x_max) continue;
    sum += std::max(0.0, std::min(c.y + half, w.y_max) - std::max(c.y - half, w.y_min)) * half * pi / n;
  }
  return sum;
}

TEST(DiskWindowArea, OfADiskInsideIsTheWholeDisk) {
  EXPECT_DOUBLE_EQ(disk_window_area({0.3, 0.4}, 0.2, {0, 1, 0, 1}), pi * 0.04);
}

TEST(DiskWindowArea, OfADiskOutsideIsNothing) {
  EXPECT_EQ(disk_window_area({-0.2, 0.5}, 0.2, {0, 1, 0, 1}), 0);
  EXPECT_NEAR(disk_window_area({1.15, 1.15}, 0.2, {0, 1, 0, 1}), 0,
              1e-15);  // reaches both sides' lines, not the corner
}

TEST(DiskWindowArea, OnASideIsHalfAndOnACornerAQuarter) {
  EXPECT_NEAR(disk_window_area({0, 0.5}, 0.2, {0, 1, 0, 1}), pi * 0.02, 1e-15);
  EXPECT_NEAR(disk_window_area({1, 1}, 0.2, {0, 1, 0, 1}), pi * 0.01, 1e-15);
}

TEST(DiskWindowArea, OfADiskAroundTheWindowIsTheWindow) {
  EXPECT_NEAR(disk_window_area({0.5, 0.5}, 5, {0, 1, 0, 1}), 1, 1e-13);
}

TEST(DiskWindowArea, OfASegmentHasItsClosedForm) {
  const double r = 1.3, d = 0.4;  // the side cuts at distance d from the centre
  EXPECT_NEAR(disk_window_area({-d, 0}, r, {0, 9, -9, 9}), r * r * std::acos(d / r) - d * std::sqrt(r * r - d * d),
              1e-14);
}

RC_GTEST_PROP(DiskWindowArea, AgreesWithQuadrature, ()) {
  const auto coordinate = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  const Vec2 c{coordinate(-1500, 2500), coordinate(-1500, 2500)};
  const double r = coordinate(50, 1500);
  const Rectangle w{0, coordinate(100, 1500), 0, coordinate(100, 1500)};
  RC_ASSERT(std::abs(disk_window_area(c, r, w) - by_quadrature(c, r, w)) < 2e-4 * r * r);
}

RC_GTEST_PROP(DiskWindowArea, OfThePartsOfAWindowAddsUp, ()) {
  const auto coordinate = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  const Vec2 c{coordinate(-500, 1500), coordinate(-500, 1500)};
  const double r = coordinate(10, 900), cut = coordinate(1, 999);
  const double parts = disk_window_area(c, r, {0, cut, 0, 1}) + disk_window_area(c, r, {cut, 1, 0, 1});
  RC_ASSERT(std::abs(parts - disk_window_area(c, r, {0, 1, 0, 1})) < 1e-14);
}

}  // namespace
}  // namespace arenite::geometry
