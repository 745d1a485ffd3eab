#pragma once
#include <string>

#include "io/image.hpp"

namespace arenite::io {

/// A two-dimensional dataset of whole numbers, or a slice along the first axis of a three-dimensional one (see
/// read_image). Rows point down, as NumPy and HDF5 viewers store and show pictures.
Image read_hdf5_image(const std::string& bytes, const std::string& file, const ImageChoice& choice);

}  // namespace arenite::io
