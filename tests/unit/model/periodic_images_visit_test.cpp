#include "model/periodic_images.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "core/random.hpp"

namespace arenite {
namespace {

TEST(Images, AreAllThatOverlapTheWindow) {
  RandomStream random(1, Purpose::test);
  for (int k = 0; k < 200; ++k) {
    Domain domain;
    domain.wall[right].position = 3;
    domain.wall[top].position = 2;
    domain.periodic[0] = k % 4 > 0;
    domain.periodic[1] = k % 4 > 1;
    domain.tilt = random.uniform(-5, 5);
    const auto rectangle = [&] {
      const double x = random.uniform(-4, 4), y = random.uniform(-4, 4);
      return geometry::Rectangle{x, x + random.uniform(0, 4), y, y + random.uniform(0, 4)};
    };
    const geometry::Rectangle extent = rectangle(), window = rectangle();
    std::multiset<std::pair<int, int>> found, wanted;
    for_each_image(domain, extent, window, [&](const ImageShift& image) {
      found.insert({image.columns, image.rows});
      EXPECT_DOUBLE_EQ(image.shift.x, 3 * image.columns + image.rows * domain.tilt);
      EXPECT_DOUBLE_EQ(image.shift.y, 2 * image.rows);
    });
    for (int row = -8; row <= 8; ++row)
      for (int column = -24; column <= 24; ++column) {
        if ((row != 0 && !domain.periodic[1]) || (column != 0 && !domain.periodic[0])) continue;
        const double x = 3 * column + row * domain.tilt, y = 2 * row;
        if (geometry::overlap({extent.x_min + x, extent.x_max + x, extent.y_min + y, extent.y_max + y}, window))
          wanted.insert({column, row});
      }
    EXPECT_EQ(found, wanted);
  }
}

TEST(Images, OfSpaceAreThoseWhoseWayLiesBetween) {
  RandomStream random(2, Purpose::test);
  const double size[3] = {3, 2, 4};
  for (int k = 0; k < 60; ++k) {
    DomainIn<3> domain;
    for (int axis = 0; axis < 3; ++axis) {
      domain.wall[2 * axis + 1].position = size[axis];
      domain.periodic[axis] = k % 4 != axis;
    }
    domain.tilt = random.uniform(-5, 5);
    const auto vector = [&](double low, double high) {
      return by_axis<3>([&](int) { return random.uniform(low, high); });
    };
    const Vec3 least = vector(-9, 1), most = least + vector(0, 9);
    std::multiset<std::array<int, 3>> found, wanted;
    for_images_between(domain, least, most, [&](const Cells<3>& image) { found.insert({image.x, image.y, image.z}); });
    for (int z = -6; z <= 6; ++z)
      for (int y = -8; y <= 8; ++y)
        for (int x = -24; x <= 24; ++x) {
          const int cells[3] = {x, y, z};
          const Vec3 way{3.0 * x + y * domain.tilt, 2.0 * y, 4.0 * z};
          bool is_between = true;
          for (int axis = 0; axis < 3; ++axis)
            is_between = is_between && (cells[axis] == 0 || domain.periodic[axis]) && way[axis] >= least[axis] &&
                         way[axis] <= most[axis];
          if (is_between) wanted.insert({x, y, z});
        }
    EXPECT_EQ(found, wanted);
  }
}

}  // namespace
}  // namespace arenite
