#include "geometry/outline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "geometry/rectangle.hpp"
#include "geometry/union_area.hpp"

namespace arenite::geometry {
namespace {

const Rectangle wide{-10, 10, -10, 10};

Outline box(double x0, double x1, double y0, double y1) {
  return {Outline::Kind::quadrilateral, {Vec2{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}, 0};
}

double area_of(std::vector<Outline> outlines, const Rectangle& window = wide) { return union_area(outlines, window); }

TEST(UnionArea, OfOneShapeIsItsArea) {
  EXPECT_NEAR(area_of({Outline::disk({1, 2}, 3)}), 9 * std::numbers::pi, 1e-13);
  EXPECT_NEAR(area_of({box(0, 2, 1, 4)}), 6, 1e-14);
  // A square without the half disk that touches two of its corners.
  const Outline hollow{Outline::Kind::hollow, {Vec2{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {1, 3}, std::sqrt(2)};
  EXPECT_NEAR(area_of({hollow}), 4 - (0.5 * std::numbers::pi - 1), 1e-14);
}

TEST(UnionArea, CountsTheLensOfTwoDisksOnce) {
  for (const double d : {1e-6, 0.3, 1.0, 1.7, 2 - 1e-9, 2.0, 2.5}) {
    const double lens = d < 2 ? 2 * std::acos(d / 2) - 0.5 * d * std::sqrt(4 - d * d) : 0;
    EXPECT_NEAR(area_of({Outline::disk({0, 0}, 1), Outline::disk({d * 0.6, d * 0.8}, 1)}), 2 * std::numbers::pi - lens,
                1e-9 + 1e-13)
        << d;
  }
}

TEST(UnionArea, TakesBoundariesThatCoincideOnce) {
  const Outline disk = Outline::disk({0.5, 0}, 1);
  EXPECT_NEAR(area_of({disk, disk, disk}), std::numbers::pi, 1e-12);
  EXPECT_NEAR(area_of({box(0, 1, 0, 1), box(0, 1, 0, 1)}), 1, 1e-12);
  EXPECT_NEAR(area_of({box(0, 1, 0, 1), box(1, 2, 0, 1)}), 2, 1e-12);  // flush
  EXPECT_NEAR(area_of({box(0, 2, 0, 1), box(1, 3, 0, 1), box(0, 1, 0, 2)}), 4, 1e-12);
  EXPECT_NEAR(area_of({box(-1, 1, 0, 1), disk, Outline::disk({0.5, 0}, 0.5)}), area_of({box(-1, 1, 0, 1), disk}),
              1e-12);
}

TEST(UnionArea, IsClippedToTheWindow) {
  const Rectangle unit{0, 1, 0, 1};
  EXPECT_NEAR(area_of({box(-1, 2, -1, 2)}, unit), 1, 1e-14);
  EXPECT_NEAR(area_of({box(0, 1, 0, 1)}, unit), 1, 1e-12);  // flush with the window
  EXPECT_NEAR(area_of({box(1, 2, 0, 1)}, unit), 0, 1e-12);  // flush outside
  EXPECT_NEAR(area_of({box(-1, 0.25, -1, 0.5)}, unit), 0.125, 1e-14);
  EXPECT_NEAR(area_of({Outline::disk({0, 0}, 1)}, unit), std::numbers::pi / 4, 1e-14);
  EXPECT_NEAR(area_of({Outline::disk({1e6, 1e6}, 1)}, {1e6, 1e6 + 1, 1e6, 1e6 + 1}), std::numbers::pi / 4, 1e-13);
}

RC_GTEST_PROP(UnionArea, OfOneDiskAgreesWithItsClosedForm, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), Purpose::test);
  const Vec2 centre{random.uniform(-2, 2), random.uniform(-2, 2)};
  const double radius = random.uniform(0.01, 3);
  const Rectangle window{-1, random.uniform(-0.9, 2), -1, random.uniform(-0.9, 2)};
  RC_ASSERT(std::abs(area_of({Outline::disk(centre, radius)}, window) - disk_window_area(centre, radius, window)) <
            1e-12);
}

/// The same by counting the points of a lattice.
double by_points(const std::vector<Outline>& outlines, const Rectangle& w, int n) {
  std::size_t inside = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const Vec2 p{w.x_min + (x + 0.5) * w.width() / n, w.y_min + (y + 0.5) * w.height() / n};
      for (const auto& o : outlines)
        if (contains(o, p)) {
          ++inside;
          break;
        }
    }
  return static_cast<double>(inside) * w.area() / n / n;
}

RC_GTEST_PROP(UnionArea, OfManyShapesAgreesWithCountingPoints, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), Purpose::test);
  std::vector<Outline> outlines;
  const int shapes = *rc::gen::inRange(0, 12);
  for (int k = 0; k < shapes; ++k) {
    const Vec2 c{random.uniform(-1, 1), random.uniform(-1, 1)};
    const double r = random.uniform(0.05, 0.5), turn = random.uniform(0, 7);
    if (k % 2) {
      outlines.push_back(Outline::disk(c, r));
      continue;
    }
    const Vec2 u{r * std::cos(turn), r * std::sin(turn)}, v = random.uniform(0.2, 2) * perpendicular(u);
    Outline o{Outline::Kind::quadrilateral, {c - u - v, c + u - v, c + 0.5 * u + v, c - u + v}, {}, 0};
    if (k % 4 == 0) {
      o = {Outline::Kind::hollow, {c - u - v, c + u - v, c + u + v, c - u + v}, c + 2.0 * v, norm(u + v)};
      if (norm(v) <= 0.45 * norm(u)) continue;  // the circle would reach the edge across
    }
    outlines.push_back(o);
  }
  const Rectangle window{-0.9, 0.8, -1, 0.7};
  const int n = 400;
  RC_ASSERT(std::abs(union_area(outlines, window) - by_points(outlines, window, n)) < 0.004);
}

}  // namespace
}  // namespace arenite::geometry
