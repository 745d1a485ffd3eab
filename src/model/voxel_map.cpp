#include "model/voxel_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/problems.hpp"

namespace arenite {

VoxelMap make_voxel_map(int width, int height, int depth, double dx) {
  if (width < 1 || height < 1 || depth < 1)
    throw refusal("a voxel map has at least one voxel along each axis, not {} x {} x {}", width, height, depth);
  const double count = static_cast<double>(width) * height * depth;
  if (count > std::numeric_limits<std::int32_t>::max())
    throw refusal("{} x {} x {} voxels are more than 2^31 - 1; cut the image into parts", width, height, depth);
  VoxelMap map{width, height, depth, dx, {}, {}, {}};
  map.phase.assign(static_cast<std::size_t>(count), Phase::empty);
  map.grain.assign(static_cast<std::size_t>(count), -1);
  return map;
}

void check(const VoxelMap& map) {
  Problems problems;
  if (map.width < 1 || map.height < 1 || map.depth < 1)
    problems.add("a voxel map of {} x {} x {} voxels has nothing in it", map.width, map.height, map.depth);
  const auto wanted =
      static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height) * static_cast<std::size_t>(map.depth);
  if (map.phase.size() != wanted || map.grain.size() != wanted)
    problems.add("a voxel map of {} x {} x {} voxels needs {} phases and grain labels, not {} and {}", map.width,
                 map.height, map.depth, wanted, map.phase.size(), map.grain.size());
  if (!(map.dx > 0) || !std::isfinite(map.dx))
    problems.add("the side of a voxel is {:g} m; give a positive one", map.dx);
  const auto grains = static_cast<std::int32_t>(map.grain_class.size());
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < std::min(map.phase.size(), map.grain.size()); ++k) {
    const bool particle = map.phase[k] == Phase::particle;
    wrong += particle ? map.grain[k] < 0 || map.grain[k] >= grains : map.grain[k] != -1;
  }
  if (wrong > 0)
    problems.add("{} voxels have a grain label that does not fit their phase (particles: 0 to {}, others: -1)", wrong,
                 grains - 1);
  problems.raise();
}

}  // namespace arenite
