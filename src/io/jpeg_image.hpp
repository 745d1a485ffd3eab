#pragma once
#include <string>

#include "io/image.hpp"

namespace arenite::io {

/// The picture in the bytes of a JPEG file, grey or in colour (see read_image), "file" in its messages. InputError
/// without a channel, for four inks, and for what the decoder had to guess.
Image read_jpeg(const std::string& bytes, const std::string& file, const ImageChoice& choice);

}  // namespace arenite::io
