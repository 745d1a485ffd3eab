#include "solid/grid/label_grains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "io/volume/spheres.hpp"
#include "solid/grid/rasterise_spheres.hpp"

namespace arenite::grid {
namespace {

constexpr geometry::LabelOptions cut_at_necks{geometry::Labelling::watershed, 1};

SpherePack packed_spheres() {
  std::vector<std::string> notes;
  return io::read_spheres(ARENITE_SOURCE_DIR "/examples/33-cemented-spheres/spheres.out", notes);
}

/// Share of the particles' voxels that are owned by the grain which has most of their sphere.
double owned_rightly(const VoxelMap& known, const VoxelMap& found) {
  std::map<std::int32_t, std::map<std::int32_t, int>> voxels;
  for (std::size_t k = 0; k < known.size(); ++k)
    if (known.grain[k] >= 0) ++voxels[found.grain[k]][known.grain[k]];
  double right = 0, all = 0;
  for (const auto& [grain, of_sphere] : voxels) {
    int most = 0;
    for (const auto& [sphere, count] : of_sphere) most = std::max(most, count), all += count;
    right += most;
  }
  return right / all;
}

TEST(LabelVoxels, EverySphereOfAPackingIsFoundAgain) {
  const SpherePack pack = packed_spheres();
  const VoxelMap known = rasterise_spheres(pack, {}, 128);
  VoxelMap found = known;
  label_grains(found, {}, true);
  EXPECT_LT(found.grain_class.size(), 150u);  // they touch
  label_grains(found, cut_at_necks, true);
  check(found);
  EXPECT_EQ(found.grain_class.size(), pack.size());
  EXPECT_GT(owned_rightly(known, found), 0.98);
  VoxelMap again = known;
  label_grains(again, cut_at_necks, true);
  EXPECT_EQ(again.grain, found.grain);
  label_grains(again, cut_at_necks);  // faces cut grains, which count more than once then
  EXPECT_GT(again.grain_class.size(), pack.size());
}

TEST(LabelVoxels, GrainsWithoutVoxelsAreLeftOut) {
  VoxelMap map = make_voxel_map(3, 1, 1, 1);
  map.phase = {Phase::particle, Phase::matrix, Phase::particle};
  map.grain = {3, -1, 1};
  map.grain_class.assign(5, GrainClass::none);
  drop_absent_grains(map);
  check(map);
  EXPECT_EQ(map.grain, (std::vector<std::int32_t>{1, -1, 0}));
  EXPECT_EQ(map.grain_class.size(), 2u);
}

}  // namespace
}  // namespace arenite::grid
