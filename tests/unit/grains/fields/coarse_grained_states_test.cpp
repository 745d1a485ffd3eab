#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace arenite::fields {
namespace {

TEST(StateFields, TheRateOfShearIsThatOfTheHistory) {
  const History history{{{"time", "s", {1, 2, 3, 4}}, {"shear_strain", "", {0, 2, 4, 5}}}};
  EXPECT_EQ(shear_rate_at(history, 1), 2);
  EXPECT_EQ(shear_rate_at(history, 2.5), 2);
  EXPECT_EQ(shear_rate_at(history, 9), 1);
  EXPECT_EQ(shear_rate_at({}, 1), 0);
}

TEST(StateFields, NeedGrainsAndABox) {
  Packing packing;
  EXPECT_FALSE(has_fields(packing));
  packing.materials = {{"glass", 2500, 1, 0}};
  packing.grains.resize(2);
  packing.grains.radius = {1, 3};
  EXPECT_FALSE(has_fields(packing));
  EXPECT_EQ(packing.grains.mean_diameter(), 4);
  packing.domain.wall[right].position = packing.domain.wall[top].position = 20;
  packing.domain.thickness = 2;
  EXPECT_TRUE(has_fields(packing));
  const auto f = coarse_fields(packing, 0, 1, grid_over<2>(packing.domain, 2));
  EXPECT_EQ(f.grid.count.x, 10);
}

TEST(StateFields, OfSpheresNeedNoThickness) {
  PackingIn<3> packing;
  packing.materials = {{"glass", 2500, 1, 0}};
  packing.grains.resize(1);
  packing.grains.radius = {1};
  EXPECT_FALSE(has_fields(packing));
  for (const int side : {right, top, front}) packing.domain.wall[side].position = 4 + side;
  EXPECT_TRUE(has_fields(packing));
  const auto f = coarse_fields(packing, 0, 1, grid_over<3>(packing.domain, 2));
  EXPECT_EQ(f.grid.count, (Cells<3>{3, 4, 5}));
  EXPECT_THROW(grid_over<3>(packing.domain, 1e-3), InputError);  // of 5e11 points
}

}  // namespace
}  // namespace arenite::fields
