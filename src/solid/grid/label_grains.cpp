#include "solid/grid/label_grains.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/mapped.hpp"

namespace arenite::grid {

void label_grains(VoxelMap& map, const geometry::LabelOptions& options, bool periodic) {
  const auto inside = mapped<std::uint8_t>(map.phase, [](Phase p) { return p == Phase::particle; });
  auto found = geometry::label_cells({map.width, map.height, map.depth, periodic}, inside, options);
  map.grain = std::move(found.label);
  map.grain_class.assign(static_cast<std::size_t>(found.count), GrainClass::none);
}

void label_alike(VoxelMap& map) {
  for (std::size_t k = 0; k < map.size(); ++k) map.grain[k] = map.phase[k] == Phase::particle ? 0 : -1;
  map.grain_class.assign(1, GrainClass::none);
}

void drop_absent_grains(VoxelMap& map) {
  std::vector<std::int32_t> number(map.grain_class.size(), -1);
  for (const std::int32_t g : map.grain)
    if (g >= 0) number[static_cast<std::size_t>(g)] = 0;
  std::size_t left = 0;
  for (std::size_t g = 0; g < number.size(); ++g) {
    if (number[g] < 0) continue;
    map.grain_class[left] = map.grain_class[g];
    number[g] = static_cast<std::int32_t>(left++);
  }
  map.grain_class.resize(left);
  for (std::int32_t& g : map.grain)
    if (g >= 0) g = number[static_cast<std::size_t>(g)];
}

}  // namespace arenite::grid
