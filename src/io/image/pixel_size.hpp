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
  std::string by = {};            ///< the words of the file that state it, where a user may doubt them
  std::string remark = {};        ///< a sentence on what was not understood; empty: all was
};

/// Of which pictures it is asked.
struct StatedOf {
  std::string dataset = {};  ///< of an HDF5 file; empty: the only one that can be meant
  bool is_stack = false;
  bool dx_given = false;  ///< pixels are known to be squares, whatever the file states
};

/// InputError where it states that pixels are no squares, unless their side is given: then it states none.
StatedVoxel stated_voxel(const Bytes& picture, const StatedOf& of = {});

/// Side of a square pixel (m) that a TIFF file (resolution, with the unit of ImageJ or an inch or a centimetre; OME's
/// PhysicalSize), a PNG file (pHYs) or a dataset of HDF5 (hdf5/spacing.hpp) states. Nothing where it states none, or a
/// resolution of screens and printers (72, 96, 150, 300 per inch and the like), which programs write that know of no
/// sample. InputError where it states that pixels are no squares.
std::optional<double> stated_pixel(const std::filesystem::path& picture, const StatedOf& of = {});

/// What is told of a pixel that a file states where nothing gives the side of one.
std::string told_pixel(double pixel);

/// What is told of a side (m) of a pixel or a voxel (`what`) that a file states where another is given; empty where
/// they differ by no more than rounding.
std::string told_other_side(const char* what, double stated, double given);

}  // namespace arenite::io
