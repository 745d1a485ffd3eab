#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace arenite::geometry {
namespace {

Polygon regular(int corners, double radius, double sense) {
  Polygon p;
  for (int k = 0; k < corners; ++k) {
    const double angle = sense * 2 * std::numbers::pi * k / corners;
    p.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return p;
}

TEST(Polygon, HasItsAreaInEitherSense) {
  for (const double sense : {1.0, -1.0})
    EXPECT_NEAR(area_of(regular(6, 2, sense)), 6 * std::sqrt(3.0), 1e-12);  // 3 sqrt(3)/2 r^2
}

TEST(Polygon, EnclosesWhatIsWithinItsHollowsNot) {
  const Polygon hollow{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  EXPECT_TRUE(encloses(hollow, {0.5, 2}));
  EXPECT_TRUE(encloses(hollow, {2, 0.5}));
  EXPECT_FALSE(encloses(hollow, {2, 2}));
  EXPECT_FALSE(encloses(hollow, {5, 1}));
}

TEST(Polygon, IsNearestOnASideOrAtACorner) {
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(way_from(square, {0.4, -3}), (Vec2{0, -3}));
  EXPECT_EQ(way_from(square, {4, 5}), (Vec2{3, 4}));
  EXPECT_NEAR(norm(way_from(square, {0.5, 0.9})), 0.1, 1e-15);
}

}  // namespace
}  // namespace arenite::geometry
