#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "io/image/image.hpp"
#include "model/image.hpp"

namespace arenite::workflow {

/// A picture to find grains in.
struct GrainPicture {
  FloatImage image;
  std::int64_t frames = 1;   ///< that it is the mean of
  std::size_t replaced = 0;  ///< bad pixels that stand replaced by good neighbours
};

/// How a picture of grains that stands alone is read and told.
struct GrainPictureKeys {
  std::optional<std::int64_t> frame;  ///< unset: the mean of all
  io::Channel channel = io::Channel::grey;
  std::vector<double> origin;  ///< column and row of the pixel at x = y = 0; empty: the lower left corner
  std::string materials;       ///< by brightness, with commas between; empty: found
};
void declare(ParameterVisitor& visitor, GrainPictureKeys& keys);

/// Reads a picture or a film, whose frames are the choice's slices; without one it is the mean of all. In a film bad
/// pixels (by level, and by noise from eight frames on) are replaced. InputError for a file that is neither, or a frame
/// that the film does not hold.
GrainPicture read_grain_picture(const std::filesystem::path& path, const io::ImageChoice& choice);

}  // namespace arenite::workflow
