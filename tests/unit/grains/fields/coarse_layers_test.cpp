#include "grains/fields/coarse_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace arenite::fields {
namespace {

/// Two spheres of radius 0.5 that touch, in a periodic cell that the kernel fits into.
PackingIn<3> pair() {
  PackingIn<3> packing;
  packing.materials = {{"glass", 2500, 1, 0}};
  packing.grains.resize(2);
  packing.grains.radius = {0.5, 0.5};
  packing.grains.position = {{4, 4, 4}, {4.6, 4.8, 4}};
  for (int axis = 0; axis < 3; ++axis) {
    packing.domain.periodic[axis] = true;
    packing.domain.wall[2 * axis + 1].position = 8 + axis;
  }
  return packing;
}

template <int D> std::vector<double> layer(const CoarseFieldsIn<D>& fields, std::string_view name) {
  return values_of(*std::ranges::find(coarse_layers<D>(), name, &CoarseLayerIn<D>::name), fields);
}

CoarseFieldsIn<3> shown(const PackingIn<3>& packing) { return fields_to_show(packing, 0, grid_to_show(packing)); }

double integral(const CoarseFieldsIn<3>& fields, std::string_view name) {
  double sum = 0;
  for (const double value : layer(fields, name)) sum += value;
  return sum * fields.grid.cell_volume();
}

TEST(CoarseLayers, OfAContactAreItsForceTimesItsBranch) {
  PackingIn<3> packing = pair();
  // n from j to i; the branch from i to j is 1 long along (0.6, 0.8, 0).
  packing.contacts.add(0, 1, {-0.6, -0.8, 0}, 10, {2, -1, 3}, 0.5, 0.5);
  const auto fields = shown(packing);
  const Vec3 force = packing.contacts.force_on_i(0), branch = packing.contacts.branch(0);
  ASSERT_NEAR(norm(branch), 1, 1e-12);
  // On points a seventh of the kernel's radius apart the sum of the smooth function is its integral to 1e-4.
  const double near = 2e-4 * norm(force);
  EXPECT_NEAR(integral(fields, "pressure"), -dot(force, branch) / 3, near);
  EXPECT_NEAR(integral(fields, "shear"), 0.5 * (force.x * branch.y + force.y * branch.x), near);
  EXPECT_NEAR(integral(fields, "shear_yz"), 0.5 * (force.y * branch.z + force.z * branch.y), near);
  EXPECT_NEAR(integral(fields, "shear_xz"), 0.5 * (force.x * branch.z + force.z * branch.x), near);
  EXPECT_GT(std::abs(integral(fields, "shear_yz") - integral(fields, "shear_xz")), 10 * near);
}

TEST(CoarseLayers, OfSpheresThatMoveAsOneHaveTheirVelocity) {
  PackingIn<3> packing = pair();
  packing.grains.velocity.assign(2, {1, 2, -2});
  const auto fields = shown(packing);
  for (std::size_t k = 0; k < fields.grid.size(); ++k) {
    if (!(fields.density[k] > 0)) continue;
    EXPECT_NEAR(layer(fields, "vx")[k], 1, 1e-12);
    EXPECT_NEAR(layer(fields, "vz")[k], -2, 1e-12);
    EXPECT_NEAR(layer(fields, "speed")[k], 3, 1e-12);
    break;
  }
}

TEST(CoarseLayers, ShowSpheresOnCellsOfARadiusAndLargeSamplesOnFew) {
  PackingIn<3> packing = pair();
  const auto grid = grid_to_show(packing);
  EXPECT_EQ(grid.count, (Cells<3>{16, 18, 20}));
  EXPECT_DOUBLE_EQ(width_to_show(packing, grid), 1);
  packing.domain.wall[front].position = 96;
  const auto large = grid_to_show(packing);
  EXPECT_EQ(large.count, (Cells<3>{4, 5, 48}));
  EXPECT_DOUBLE_EQ(width_to_show(packing, large), 2) << "no kernel is narrower than a cell";
}

TEST(CoarseLayers, OfThePlaneAreAmongThoseOfSpace) {
  for (const auto& layer : coarse_layers<2>())
    EXPECT_NE(std::ranges::find(coarse_layers<3>(), layer.name, &CoarseLayerIn<3>::name), coarse_layers<3>().end());
  EXPECT_EQ(coarse_layers<3>().size(), coarse_layers<2>().size() + 3);
}

}  // namespace
}  // namespace arenite::fields
