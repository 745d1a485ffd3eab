#pragma once
#include <string>

#include "io/image.hpp"

namespace arenite::io {

/// The picture in the bytes of a TIFF file (see read_image), "file" in its messages.
Image read_tiff(const std::string& bytes, const std::string& file, const ImageChoice& choice);

}  // namespace arenite::io
