#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/volume/volume.hpp"

namespace arenite::io {

/// What the header of a .npy array says, in Python's words.
struct NumpyArray {
  std::string type;
  bool fortran = false;
  std::vector<std::int64_t> shape;
  std::size_t start = 0;
};

/// Throws InputError for what is no .npy array of numbers.
NumpyArray numpy_array_in(const Bytes& bytes);

/// Its voxels. Throws InputError where it has not three dimensions.
VolumePointer open_numpy_array(const Bytes& bytes);

}  // namespace arenite::io
