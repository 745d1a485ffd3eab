#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "solid/grid/rasterise_spheres.hpp"
#include "support/pictures.hpp"
#include "workflow/cemented_sample.hpp"

namespace arenite::workflow {
namespace {

constexpr double side = 2e-3;

/// A simple cubic lattice that touches, two spheres along each axis of a periodic cube; every second one small, where
/// it is asked for.
PackingIn<3> lattice(bool two_sizes = false) {
  PackingIn<3> packing;
  packing.materials = {{.name = "large"}, {.name = "small"}};
  for (int axis = 0; axis < 3; ++axis) {
    packing.domain.periodic[static_cast<std::size_t>(axis)] = true;
    packing.domain.wall[static_cast<std::size_t>(2 * axis + 1)].position = side;
  }
  packing.grains.resize(8);
  for (int k = 0; k < 8; ++k) {
    const auto g = static_cast<std::size_t>(k);
    packing.grains.position[g] = (side / 2) * Vec3{k % 2 + 0.1, k / 2 % 2 + 0.2, k / 4 + 0.3};
    packing.grains.material[g] = k % 2;
    packing.grains.radius[g] = side / 4 * (two_sizes && k % 2 == 1 ? 0.6 : 1);
  }
  return packing;
}

VoxelMap cemented(const PackingIn<3>& packing, const std::string& sections) {
  const auto recipe = recipe::parse_recipe(
      "dimension = 3\n[materials.glass]\ndensity = \"1 g/cm^3\"\nstiffness = \"1 kN/m\"\n[packing]\ngrains = 1\n"
      "[[populations]]\nmaterial = \"glass\"\nratio = 1\nsize = { law = \"uniform\", min = \"1 mm\", max = \"2 mm\" }\n"
      "[container]\nwidth = \"20 mm\"\ndepth = \"20 mm\"\n" +
          sections + "[[stages]]\nname = \"rest\"\n[[loads]]\nname = \"pull\"\nmethod = \"elements\"\n",
      "r.toml");
  return make_cemented_sample(recipe, packing, [](const std::string&) {});
}

double share(const VoxelMap& map, Phase phase) {
  return static_cast<double>(std::ranges::count(map.phase, phase)) / static_cast<double>(map.size());
}

TEST(CementedSpheres, APeriodicCubeIsTheCellWithTheImagesOfItsSpheres) {
  const VoxelMap map = cemented(lattice(), "[grid]\nnodes = 64\n");
  EXPECT_EQ(map.width, 64);
  EXPECT_NEAR(map.dx, side / 64, 1e-15);
  EXPECT_NEAR(share(map, Phase::particle), std::numbers::pi / 6, 3e-3);
  EXPECT_EQ(share(map, Phase::matrix), 0);
  EXPECT_EQ(map.grain_class.size(), 8u) << "an image carries the number of its sphere";
}

TEST(CementedSpheres, ACropIsCutFromTheMiddleAndNumbersTheSpheresThatItHolds) {
  PackingIn<3> packing = lattice();
  packing.domain.periodic = {};
  packing.grains.position[0] = {side / 2, side / 2, side / 2};
  for (std::size_t g = 1; g < 8; ++g) packing.grains.position[g].x += 10 * side;
  const VoxelMap map = cemented(packing, "[grid]\nnodes = 40\ncrop = \"1.2 mm\"\n");
  EXPECT_NEAR(map.dx, 1.2e-3 / 40, 1e-12);
  EXPECT_EQ(map.grain_class.size(), 1u);
  EXPECT_NEAR(share(map, Phase::particle), std::numbers::pi / 6 * std::pow(1 / 1.2, 3), 3e-3);
}

TEST(CementedSpheres, LargeAndSmallOnesAreToldApartAndTheSaturationIsMet) {
  const VoxelMap map = cemented(lattice(true), "[cement]\nsaturation = 0.1\ngap = \"0.3 mm\"\n[grid]\nnodes = 64\n");
  EXPECT_NEAR(grid::saturation_of(map), 0.1, 2e-3);
  EXPECT_EQ(std::ranges::count(map.grain_class, GrainClass::large), 4);
  EXPECT_EQ(std::ranges::count(map.grain_class, GrainClass::small), 4);
  EXPECT_EQ(share(cemented(lattice(), "[cement]\nkind = \"full\"\n[grid]\nnodes = 16\n"), Phase::empty), 0);
}

TEST(CementedSpheres, ACubeThatIsWiderThanTheSampleIsRefused) {
  EXPECT_EQ(test::complaint([] { cemented(lattice(), "[grid]\nnodes = 16\ncrop = \"2.1 mm\"\n"); }),
            "grid.crop of 2.1 mm is wider than the sample of 2 x 2 x 2 mm; ask for less");
}

}  // namespace
}  // namespace arenite::workflow
