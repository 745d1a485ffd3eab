#pragma once
#include <string>
#include <vector>

#include "io/volume/volume.hpp"

namespace arenite::io {

/// The voxels of a .npy array, with what should be known of the file beside them (`remarks`). Throws InputError where
/// it has not three dimensions.
VolumePointer open_numpy_array(const Bytes& bytes, std::vector<std::string> remarks = {});

}  // namespace arenite::io
