#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "io/results/groups.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

void transfer_voxel_map(const Hdf5Group& at, VoxelMap& map) {
  const auto group = at.group("map");
  group("width", map.width);
  group("height", map.height);
  group("depth", map.depth);
  group("dx [m]", map.dx);
  if (!at.reads() || group.has_attribute("has_length")) group("has_length", map.has_length);
  group.note("axes", "z, y, x");
  constexpr int largest = 1 << 16;
  if (at.reads())
    for (const int size : {map.width, map.height, map.depth})
      if (size < 1 || size > largest) group.refuse("has an impossible size");
  const Shape shape{map.height, map.width, map.depth};
  auto grains = static_cast<std::int64_t>(map.grain_class.size());
  transfer_phases(group, map.phase, shape);
  group.image("grain", map.grain, shape);
  group("grains", grains);
  if (!at.reads()) return;
  if (grains < 0 || grains > static_cast<std::int64_t>(map.phase.size()))
    group.refuse("has an impossible number of grains");
  map.grain_class.assign(static_cast<std::size_t>(grains), GrainClass::none);
  refuse_unsound(group, map);
}

void transfer_voxels(const Hdf5Group& at, VoxelResult& result) {
  transfer_origin(at, result);
  transfer_voxel_map(at, result.map);
  const auto group = at.group("field");
  VoxelStress& field = result.field;
  field.width = result.map.width, field.height = result.map.height, field.depth = result.map.depth;
  field.dx = result.map.dx;
  const Shape shape{field.height, field.width, field.depth};
  for (const VoxelColumn& c : voxel_columns) group.image(c.name, field.*c.values, shape, c.unit);
  if (at.reads() ? group.has("damage") : !field.damage.empty()) group.image("damage", field.damage, shape, "1");
  transfer_history(at, "convergence", result.convergence);
  if (!at.reads() || at.has_group("cracks")) {
    transfer_history(at, "curve", result.curve);
    at.group("cracks").records(result.cracks, Named{"x", &SpaceCrack::x, "m"}, Named{"y", &SpaceCrack::y, "m"},
                               Named{"z", &SpaceCrack::z, "m"}, Named{"type", &SpaceCrack::type},
                               Named{"strain", &SpaceCrack::strain}, Named{"along_x", &SpaceCrack::along_x},
                               Named{"along_y", &SpaceCrack::along_y}, Named{"along_z", &SpaceCrack::along_z});
  }
  transfer_numbers(at, "numbers", result.numbers);
}

}  // namespace

void write_voxels(const std::filesystem::path& path, const VoxelResult& result) {
  write_result_file(path, "voxels", transfer_voxels, result);
}

VoxelResult read_voxels(const std::filesystem::path& path) { return read_result_file(path, "voxels", transfer_voxels); }

}  // namespace arenite::io
