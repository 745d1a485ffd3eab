#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "io/disk/byte_source.hpp"

namespace arenite::io {

/// What a picture or a stack of them states of its size, m.
struct StatedVoxel {
  std::optional<double> pixel;    ///< side of a square pixel, as stated_pixel has it
  std::optional<double> spacing;  ///< from one picture of the stack to the next (ImageJ's spacing, OME's PhysicalSizeZ)
};

/// InputError where it states that pixels are no squares.
StatedVoxel stated_voxel(const Bytes& picture);

/// Side of a square pixel (m) that a TIFF file (resolution, with the unit of ImageJ or an inch or a centimetre; OME's
/// PhysicalSize) or a PNG file (pHYs) states. Nothing where it states none, or a resolution of screens and printers
/// (72, 96, 150, 300 per inch and the like), which programs write that know of no sample. InputError where it states
/// that pixels are no squares.
std::optional<double> stated_pixel(const std::filesystem::path& picture);

/// What is told of a pixel that a file states where nothing gives the side of one.
std::string told_pixel(double pixel);

}  // namespace arenite::io
