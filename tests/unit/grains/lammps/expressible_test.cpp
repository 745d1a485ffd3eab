#include "grains/lammps/expressible.hpp"

#include <gtest/gtest.h>

namespace arenite::lammps {
namespace {

template <int D> Container<D> of_sides(Vec<D> size) {
  Container<D> container;
  for (int axis = 0; axis < D; ++axis) container.wall[static_cast<std::size_t>(2 * axis + 1)].position = size[axis];
  return container;
}

TEST(Expressible, ProcessesShareAContainerWithTheLeastSurfaceBetweenThem) {
  EXPECT_DOUBLE_EQ(narrowest_part<3>(of_sides<3>({16, 20, 18}), 2), 10);
  EXPECT_DOUBLE_EQ(narrowest_part<3>(of_sides<3>({16, 20, 18}), 8), 8);
  EXPECT_DOUBLE_EQ(narrowest_part<3>(of_sides<3>({1, 1, 30}), 6), 1);
  EXPECT_DOUBLE_EQ(narrowest_part<2>(of_sides<2>({12, 4}), 3), 4);
  EXPECT_DOUBLE_EQ(narrowest_part<2>(of_sides<2>({12, 4}), 1), 4);
}

}  // namespace
}  // namespace arenite::lammps
