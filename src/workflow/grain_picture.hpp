#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "io/image.hpp"
#include "model/image.hpp"

namespace arenite::study {

/// What of a file is looked at for grains.
struct PictureChoice {
  std::optional<std::int64_t> frame = {};      ///< of a film, from 0; none: the mean of all frames
  io::Channel channel = io::Channel::grey;     ///< of a coloured picture
  std::string dataset = {};                    ///< of an HDF5 file
};

/// A picture to find grains in.
struct GrainPicture {
  FloatImage image;
  std::int64_t frames = 1;                     ///< that it is the mean of
  std::size_t replaced = 0;                    ///< bad pixels that stand replaced by good neighbours
  bool film = false;
};

/// Reads a picture or a film; in a film bad pixels (by level, and by noise from eight frames on) are replaced. InputError
/// for a file that is neither, or a frame that the film does not hold.
GrainPicture read_grain_picture(const std::filesystem::path& path, const PictureChoice& choice = {});

}  // namespace arenite::study
