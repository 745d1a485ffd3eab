#pragma once
#include "io/volume/volume.hpp"

namespace arenite::io {

/// The voxels of a .npy array. Throws InputError where it has not three dimensions.
VolumePointer open_numpy_array(const Bytes& bytes);

}  // namespace arenite::io
