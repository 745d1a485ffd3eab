#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "io/disk/numpy_header.hpp"
#include "io/export/export.hpp"
#include "io/results/groups.hpp"

namespace arenite::io {
namespace {

/// One array a file, NAME_COLUMN.npy.
class ArrayFiles {
 public:
  ArrayFiles(std::string name, std::vector<std::int64_t> shape) : name_(std::move(name)), shape_(std::move(shape)) {}

  template <class T> void add(const std::string& column, const std::vector<T>& values) {
    static_assert(std::is_same_v<T, std::uint8_t> || std::is_same_v<T, std::int32_t> || std::is_same_v<T, float>);
    constexpr std::string_view type = std::is_same_v<T, float>          ? "<f4"
                                      : std::is_same_v<T, std::int32_t> ? "<i4"
                                                                        : "|u1";
    files_.push_back(
        {name_ + "_" + column + ".npy",
         numpy_file(type, shape_, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)})});
  }
  template <class Map> void add_sample(const Map& map) {
    add("phase", mapped(map.phase, [](Phase p) { return static_cast<std::uint8_t>(p); }));
    add("grain", map.grain);
  }
  std::vector<NamedBytes> take() { return std::move(files_); }

 private:
  std::string name_;
  std::vector<std::int64_t> shape_;
  std::vector<NamedBytes> files_;
};

std::vector<NamedBytes> npy_voxels(const VoxelResult& r) {
  ArrayFiles files(r.name, {r.map.depth, r.map.height, r.map.width});
  files.add_sample(r.map);
  if (r.field.size() > 0)
    for (const VoxelColumn& c : voxel_columns) files.add(c.name, r.field.*c.values);
  if (!r.field.damage.empty()) files.add("damage", r.field.damage);
  return files.take();
}

std::vector<NamedBytes> npy_field(const ExportField& from) {
  const FieldResult& r = *from.result;
  ArrayFiles files(r.name, {r.map.height, r.map.width});
  files.add_sample(r.map);
  if (r.field.size() > 0)
    for (const auto& c : field_columns) files.add(c.name, mapped<float>(c.of(r.field), [](double v) { return v; }));
  return files.take();
}

}  // namespace

const ExportFormat exports::npy{
    .name = "npy",
    .sentence =
        "NumPy: phase, grain, displacements (m) and stresses (Pa) of voxels or nodes, one .npy each "
        "(NAME_sigma_zz.npy)",
    .states = {{"arrays", "z, y, x of a sample in space, y, x of a field; the first row is the lowest"},
               {"types", "phase uint8 (0 void, 1 matrix, 2 particle), grain int32 (-1 outside), others float32"},
               {"side of a voxel, units", "left out: `arenite show --json` has map.dx_m"},
               {"states of grains and contacts", "refused: `netcdf` and `csv` have them"}},
    .other_names = {"numpy"},
    .of_field = npy_field,
    .of_voxels = npy_voxels};

}  // namespace arenite::io
