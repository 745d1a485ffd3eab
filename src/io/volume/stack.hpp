#pragma once
#include <filesystem>

#include "io/volume/volume.hpp"

namespace arenite::io {

/// The pictures of a folder, or of a name with *, one upon the other.
VolumePointer open_slices(const std::filesystem::path& path, const VolumeChoice& choice);

}  // namespace arenite::io
