#pragma once
#include <string_view>

#include "model/image.hpp"

namespace arenite::io {

/// A picture as it is meant to be seen. `orientation` is that of TIFF and EXIF, 1 to 8: which side of it the first row
/// and the first column are (1: top and left); anything else is 1.
Image upright(Image stored, int orientation);

/// The orientation that EXIF states, whose bytes begin as TIFF does; 1 where it states none.
int exif_orientation(std::string_view exif);

}  // namespace arenite::io
