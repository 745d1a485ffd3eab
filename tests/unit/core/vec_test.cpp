#include "core/vec.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace arenite {
namespace {

static_assert(std::is_aggregate_v<Vec2> && sizeof(Vec2) == 2 * sizeof(double));
static_assert(std::is_aggregate_v<Vec3> && sizeof(Vec3) == 3 * sizeof(double));

TEST(Vec, PlaneHasSumsAndProducts) {
  Vec2 a{1, 2};
  a += Vec2{3, -1};
  a -= {0.5, 0.25};
  EXPECT_EQ(a.x, 3.5);
  EXPECT_EQ(a.y, 0.75);
  const Vec2 b = 2 * a - -Vec2{1, 1} + Vec2{0, 1};
  EXPECT_EQ(b.x, 8);
  EXPECT_EQ(b.y, 3.5);
  EXPECT_EQ(dot(a, b), 3.5 * 8 + 0.75 * 3.5);
  EXPECT_EQ(norm(Vec2{3, 4}), 5);
  EXPECT_EQ(cross(Vec2{1, 0}, Vec2{0, 1}), 1);
  EXPECT_EQ(dot(perpendicular(b), b), 0);
  EXPECT_EQ(cross(b, perpendicular(b)), dot(b, b));
}

TEST(Vec, SpaceHasSumsAndProducts) {
  Vec3 a{1, 2, 3};
  a += Vec3{3, -1, 1};
  a -= {0.5, 0.25, 2};
  EXPECT_EQ(a.x, 3.5);
  EXPECT_EQ(a.y, 0.75);
  EXPECT_EQ(a.z, 2);
  const Vec3 b = 2 * a - -Vec3{1, 1, 1} + Vec3{0, 1, -1};
  EXPECT_EQ(b.x, 8);
  EXPECT_EQ(b.y, 3.5);
  EXPECT_EQ(b.z, 4);
  EXPECT_EQ(dot(a, b), 3.5 * 8 + 0.75 * 3.5 + 2 * 4);
  EXPECT_EQ(norm(Vec3{2, 3, 6}), 7);
  const Vec3 z = cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}), normal = cross(a, b);
  EXPECT_EQ(z.x, 0);
  EXPECT_EQ(z.y, 0);
  EXPECT_EQ(z.z, 1);
  EXPECT_EQ(dot(normal, a), 0);
  EXPECT_EQ(dot(normal, b), 0);
}

TEST(Vec, TraceOfADyadIsTheDotProduct) {
  const Vec2 a{2, 3}, b{5, -7};
  EXPECT_EQ(trace(outer(a, b)), dot(a, b));
  EXPECT_EQ((2 * outer(a, b)).xy, -28);
}

}  // namespace
}  // namespace arenite
