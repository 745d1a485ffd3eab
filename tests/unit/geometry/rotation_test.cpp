#include "geometry/rotation.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace arenite::geometry {
namespace {

void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Rotation, TurnsByItsVectorAndIsFoundAgain) {
  const Vec3 axis{1.0 / 3, -2.0 / 3, 2.0 / 3}, aside{2.0 / 3, 2.0 / 3, 1.0 / 3};
  for (const double angle : {1e-9, 1.99e-4, 2.01e-4, 0.1, 1.5, 3.1}) {
    const Rotation r = rotation_by(angle * axis);
    expect_near(turned(r, aside), std::cos(angle) * aside + std::sin(angle) * cross(axis, aside), 1e-15);
    expect_near(vector_of(r), angle * axis, 1e-15 + 1e-14 * angle);
    expect_near(vector_of({-r.cosine, -r.sine}), angle * axis, 1e-15 + 1e-14 * angle);
    expect_near(turned(inverse(r) * r, aside), aside, 1e-15);
  }
  EXPECT_EQ(vector_of({}), Vec3{});
}

/// A quarter about x, then one about y, is a third of a turn about a diagonal of space.
TEST(Rotation, OneAfterTheOtherIsTheirProduct) {
  const double quarter = std::numbers::pi / 2, third = 2 * std::numbers::pi / 3 / std::sqrt(3.0);
  const Rotation both = rotation_by({0, quarter, 0}) * rotation_by({quarter, 0, 0});
  expect_near(vector_of(both), {third, third, -third}, 1e-15);
  const Rotation drifted{1.001 * both.cosine, 1.001 * both.sine};
  expect_near(vector_of(normalised(drifted)), vector_of(both), 1e-15);
}

}  // namespace
}  // namespace arenite::geometry
