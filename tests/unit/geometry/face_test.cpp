#include "geometry/face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace arenite::geometry {
namespace {

/// A kite in an oblique plane.
const std::vector<Vec3> kite{{1, 0, 0}, {0, 2, 1}, {-1, 0, 0}, {0, -1, -0.5}};

TEST(Face, NearestPointIsNeverFartherThanAnyOther) {
  RandomStream random(1, Purpose::test);
  for (int n = 0; n < 200; ++n) {
    const Vec3 place{random.uniform(-2, 2), random.uniform(-2, 3), random.uniform(-2, 2)},
        nearest = nearest_on_face(kite, place);
    double least = HUGE_VAL;  // over a grid of points of the face, by its two triangles
    constexpr int steps = 40;
    for (const int apex : {1, 3})
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j) {
          const double a = i / 40.0, b = j / 40.0;
          least = std::min(least, norm(place - (a * kite[0] + b * kite[2] + (1 - a - b) * kite[apex])));
        }
    const double distance = norm(place - nearest);
    EXPECT_LE(distance, least + 1e-12);
    EXPECT_GT(distance, least - 0.07);  // the grid's cells are 0.05 and 0.06 wide
    EXPECT_NEAR(norm(nearest - nearest_on_face(kite, nearest)), 0, 1e-14);
  }
}

TEST(Faces, EndAroundThemAllAndAroundTheirOpening) {
  std::vector<std::vector<Vec3>> parts;  // a square frame of four faces
  const auto corner = [](double half, int k) {
    return Vec3{(k == 0 || k == 3) ? -half : half, 1, k < 2 ? -half : half};
  };
  for (int k = 0; k < 4; ++k)
    parts.push_back({corner(1, k), corner(1, (k + 1) % 4), corner(0.25, (k + 1) % 4), corner(0.25, k)});
  const std::vector<Face> faces(parts.begin(), parts.end());
  const auto lines = ends_of(faces);
  ASSERT_EQ(lines.size(), 2u);
  std::vector<double> areas;
  for (const auto& line : lines) areas.push_back(0.5 * norm(area_vector(line)));
  std::ranges::sort(areas);
  EXPECT_DOUBLE_EQ(areas[0], 0.25);
  EXPECT_DOUBLE_EQ(areas[1], 4);
  EXPECT_EQ(ends_of(std::vector<Face>{kite}).at(0).size(), 4u);
}

TEST(Face, IsTouchedWithinOnAnEdgeAndAtACorner) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  EXPECT_EQ(nearest_on_face(square, {0.3, 2, 0.6}), (Vec3{0.3, 0, 0.6}));
  EXPECT_EQ(nearest_on_face(square, {0.3, 2, -1}), (Vec3{0.3, 0, 0}));
  EXPECT_EQ(nearest_on_face(square, {2, -2, 3}), (Vec3{1, 0, 1}));
  EXPECT_EQ(area_vector(square), (Vec3{0, -2, 0}));
}

TEST(Face, MustBeFlatAndConvex) {
  EXPECT_TRUE(is_flat_and_convex(kite));
  std::vector<Vec3> bent = kite;
  bent[0].z = 0.1;
  EXPECT_FALSE(is_flat_and_convex(bent));
  EXPECT_FALSE(is_flat_and_convex(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0.1, 0.1, 0}, {0, 1, 0}}));  // a notch
  EXPECT_FALSE(is_flat_and_convex(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));      // crossed
  EXPECT_FALSE(is_flat_and_convex(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_FALSE(is_flat_and_convex(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}));
  EXPECT_TRUE(
      is_flat_and_convex(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}));  // a corner on an edge
}

TEST(Face, EdgesAreThoseWhereFacesEndOrBend) {
  // A tetrahedron has six, each of two faces.
  const std::vector<Vec3> o{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, x{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      y{{0, 0, 1}, {1, 0, 0}, {0, 0, 0}}, far{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(edges_of(std::vector<Face>{o, x, y, far}).size(), 6u);
  // A square of two triangles has its rim and no diagonal, in whatever sense they turn.
  const std::vector<Vec3> low{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, high{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Vec3> turned(high.rbegin(), high.rend());
  for (const auto& other : {high, turned}) {
    const auto rim = edges_of(std::vector<Face>{low, other});
    EXPECT_EQ(rim.size(), 4u);
    for (const auto& [a, b] : rim) EXPECT_EQ(norm(b - a), 1);
  }
}

}  // namespace
}  // namespace arenite::geometry
