#include "model/periodic_images.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace arenite
