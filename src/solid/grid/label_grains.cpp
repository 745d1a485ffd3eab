#include "solid/grid/label_grains.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/joined_sets.hpp"

namespace arenite::grid {

void label_grains(VoxelMap& map) {
  JoinedSets sets(map.size());
  const std::array<std::size_t, 3> step{1, static_cast<std::size_t>(map.width), map.index(0, 0, 1)};
  const auto particle = [&](std::size_t k) { return map.phase[k] == Phase::particle; };
  std::size_t k = 0;
  for (int z = 0; z < map.depth; ++z)
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x, ++k) {
        if (!particle(k)) continue;
        const std::array<bool, 3> inside{x > 0, y > 0, z > 0};
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (inside[axis] && particle(k - step[axis]))
            sets.join(static_cast<std::int32_t>(k - step[axis]), static_cast<std::int32_t>(k));
      }
  std::int32_t grains = 0;
  for (k = 0; k < map.size(); ++k) {
    if (!particle(k)) continue;
    const auto root = static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(k)));
    map.grain[k] = root == k ? grains++ : map.grain[root];
  }
  map.grain_class.assign(static_cast<std::size_t>(grains), GrainClass::none);
}

void label_alike(VoxelMap& map) {
  for (std::size_t k = 0; k < map.size(); ++k) map.grain[k] = map.phase[k] == Phase::particle ? 0 : -1;
  map.grain_class.assign(1, GrainClass::none);
}

}  // namespace arenite::grid
