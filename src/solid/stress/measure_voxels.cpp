#include "solid/stress/measure_voxels.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/problems.hpp"
#include "solid/stress/component_statistics.hpp"

namespace arenite::stress {

using statistics::described;

Numbers measure(const VoxelMap& map, const VoxelStress& field, const VoxelStressOptions& options,
                std::vector<std::string>& notes) {
  const int first = options.clamp_layers, layers = map.depth - 2 * first, k = options.blocks;
  if (layers < 1)
    throw refusal("leaving out {} layers at each clamp leaves none of the map's {}; leave out fewer", first, map.depth);
  Selection selection;
  selection.set.assign(map.size(), NodeSet::left_out);
  selection.block.assign(map.size(), 0);
  selection.blocks = k * k * k, selection.columns = k * k;
  selection.block_area.assign(static_cast<std::size_t>(selection.blocks), 0);
  const auto part = [k](int at, int of) { return static_cast<int>(static_cast<std::int64_t>(at) * k / of); };
  std::size_t i = map.index(0, 0, first);
  for (int z = 0; z < layers; ++z)
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x, ++i) {
        const int block = (part(z, layers) * k + part(y, map.height)) * k + part(x, map.width);
        selection.block[i] = static_cast<std::uint16_t>(block);
        selection.block_area[static_cast<std::size_t>(block)] += 1;
        if (map.phase[i] == Phase::empty) continue;
        const bool particle = map.phase[i] == Phase::particle;
        selection.set[i] =
            set_of(map.phase[i], particle ? map.grain_class[static_cast<std::size_t>(map.grain[i])] : GrainClass::none);
        ++selection.nodes;
      }
  const std::vector<float>& values = options.shear ? field.xz : field.zz;
  const std::string name = options.shear ? "sigma_xz" : "sigma_zz";
  Numbers numbers{{"nodes", described(selection.nodes, "", "Voxels of particles and matrix that are considered")}};
  numbers["options"] = {{"clamp_layers", first}};
  numbers["options"].mark(Trait::detail);
  Numbers component = component_statistics(
      selection, name, [&](std::size_t n) { return static_cast<double>(values[n]); }, false, notes);
  if (component.is_known()) numbers[name] = std::move(component);
  return numbers;
}

}  // namespace arenite::stress
