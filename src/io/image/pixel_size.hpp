#pragma once
#include <filesystem>
#include <optional>

namespace arenite::io {

/// Side of a square pixel (m) that a TIFF file (resolution, with the unit of ImageJ or an inch or a centimetre) or a
/// PNG file (pHYs) states. Nothing where it states none, or a resolution of screens and printers (72, 96, 150, 300 per
/// inch and the like), which programs write that know of no sample. InputError where it states that pixels are no
/// squares.
std::optional<double> stated_pixel(const std::filesystem::path& picture);

}  // namespace arenite::io
