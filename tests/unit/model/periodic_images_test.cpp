#include "model/periodic_images.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"

namespace {
using namespace arenite;

Domain cell(double width, double height, double tilt) {
  Domain d;
  d.periodic[0] = d.periodic[1] = true;
  d.wall[left].position = -1;
  d.wall[right].position = width - 1;
  d.wall[top].position = height;
  d.tilt = tilt;
  return d;
}

TEST(PeriodicImages, GivePairsByTheirNearestImageInShearedCells) {
  for (const double tilt : {0.0, 1.3}) {
    const Domain domain = cell(7, 5, tilt);
    RandomStream random(3, Purpose::test);
    Grains grains;
    grains.resize(60);
    for (std::size_t g = 0; g < grains.size(); ++g) {
      grains.position[g] = {random.uniform(-9, 12), random.uniform(-6, 11)};
      grains.radius[g] = random.uniform(0.2, 0.4);
    }
    std::vector<std::pair<int, int>> found, wanted;
    for (const auto& p : pairs_within(grains, domain, 0.1)) found.emplace_back(p.i, p.j);
    for (std::size_t i = 0; i < grains.size(); ++i)
      for (std::size_t j = i + 1; j < grains.size(); ++j)
        if (norm(domain.nearest_image(grains.position[i] - grains.position[j])) <=
            grains.radius[i] + grains.radius[j] + 0.1)
          wanted.emplace_back(i, j);
    EXPECT_EQ(found, wanted);
  }
}

TEST(PeriodicImages, AWrappedPointLiesInTheCellAndIsAnImageOfItself) {
  const Domain domain = cell(7, 5, 1.3);
  const Vec2 p{23.4, -17.2}, in = domain.wrapped(p);
  EXPECT_TRUE(in.x >= -1 && in.x < 6 && in.y >= 0 && in.y < 5);
  EXPECT_NEAR(norm(domain.nearest_image(p - in)), 0, 1e-12);
}

TEST(PeriodicImages, AContainerOfSpaceWrapsAndFindsTheNearestImageLikeThatOfThePlane) {
  DomainIn<3> box;
  const double sizes[] = {7, 5, 3};
  for (int axis = 0; axis < 3; ++axis) box.wall[2 * axis + 1].position = sizes[axis];
  box.periodic = {true, true, false};
  box.tilt = 1.3;
  const Vec3 p{23.4, -17.2, 8}, in = box.wrapped(p);
  EXPECT_TRUE(in.x >= 0 && in.x < 7 && in.y >= 0 && in.y < 5);
  EXPECT_EQ(in.z, 8);
  EXPECT_NEAR(norm(in + box.way(box.cell_of(p)) - p), 0, 1e-12);
  EXPECT_NEAR(norm(box.nearest_image(p - in)), 0, 1e-12);
  EXPECT_EQ(box.depth(5, p), -5);
  int cells = 0;
  box.each_near_cell([&](Cells<3> cell) {
    EXPECT_EQ(cell, (Cells<3>{cells % 3 - 1, cells / 3 - 1, 0}));
    ++cells;
  });
  EXPECT_EQ(cells, 9);
}

TEST(PeriodicImages, GrainsFarLargerThanTheirCellAreRefused) {
  Grains grains;
  grains.resize(2);
  grains.radius = {1e4, 1e4};
  EXPECT_THROW(pairs_within(grains, cell(7, 5, 0), 0), InputError);
}

}  // namespace
