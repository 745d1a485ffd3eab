#include "io/volume/numpy_array.hpp"

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/disk/numpy_header.hpp"

namespace arenite::io {

VolumePointer open_numpy_array(const Bytes& bytes, std::vector<std::string> remarks) {
  const std::string& file = bytes->name();
  const NumpyHeader array = numpy_header_in(bytes);
  if (array.shape.size() != 3)
    refuse(file, "has {} dimensions; save an array of three: slices x rows x columns", array.shape.size());
  if (!array.number) refuse(file, "has voxels of type {}; save whole numbers, or bool", array.type);
  const auto [z, y, x] = std::tuple(array.shape[0], array.shape[1], array.shape[2]);
  VolumeFacts facts = sized({x, y, z}, file);  // refuses more voxels than can be numbered
  VoxelLayout layout{.type = *array.number, .big_endian = array.big_endian, .start = array.start};
  if (array.fortran) layout.step = {z * y, z, 1};
  facts.remarks = std::move(remarks);
  return voxels_in(bytes, facts, layout);
}

}  // namespace arenite::io
