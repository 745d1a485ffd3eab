#pragma once
#include <string>

#include "io/image.hpp"

namespace arenite::io {

/// The picture in the bytes of a PNG file (see read_image), "file" in its messages.
Image read_png(const std::string& bytes, const std::string& file, const ImageChoice& choice);

}  // namespace arenite::io
