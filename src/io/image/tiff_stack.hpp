#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arenite::io {

/// What a TIFF file's description says about its images: ImageJ's lines "key=value", OME's XML, or the shape that
/// tifffile notes. Images of a hyperstack follow each other channel by channel, slice by slice or frame by frame.
struct TiffStack {
  std::string_view by = {};  ///< whose description it is; empty: none of these
  std::int64_t channels = 1, slices = 1, frames = 1;
  std::string order = "CZT";    ///< channels, slices, frames: what changes fastest is first
  double interval = 0;          ///< between frames, s; 0: not stated
  double shown_per_second = 0;  ///< at which ImageJ plays it, which need not be the camera's rate; 0: not stated
  std::vector<double> time =
      {};  ///< s, of the frames of the first slice of every channel (channels x frames); empty: not stated
  std::string unknown_unit = {};            ///< of times, which are then left aside
  double number_zero = 0, number_step = 1;  ///< ImageJ's calibration: a number n stands for zero + n step
  std::string number_unit = {};             ///< of what numbers stand for; empty: not stated
  double length_unit = 0;                   ///< of the file's resolution, m; 0: not stated by the description
  std::array<double, 3> side{};             ///< of a voxel along x, y, z, m; 0: not stated by the description
  std::int64_t images() const { return channels * slices * frames; }
  /// Number of the image of a channel and a frame in the first slice, all counted from 0.
  std::int64_t image(std::int64_t channel, std::int64_t frame) const;
};

/// `width` and `height` are those of the first image.
TiffStack stack_in(std::string_view description, std::int64_t width, std::int64_t height);

}  // namespace arenite::io
