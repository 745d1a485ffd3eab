#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/image.hpp"

namespace arenite::io {

/// How the samples of a row of pixels lie in memory, in this machine's byte order.
struct PixelLayout {
  std::string file;  ///< for messages
  int width = 0, height = 0;
  int bits = 8;      ///< of a sample: 8, 16 or 32
  int samples = 1;   ///< of a pixel; the first is grey or an index of the palette, or the first three are a colour
  bool colour = false, opacity = false, inverted = false, is_signed = false;  ///< opacity: the last sample
  Channel channel = Channel::none;  ///< what is taken of a colour; none: colour is refused
  std::vector<std::array<std::uint16_t, 3>> palette;  ///< empty: none

  std::size_t bytes_a_row() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(samples) * static_cast<std::size_t>(bits / 8);
  }
};

/// An image of no pixels or more than are allowed is an InputError.
void check_size(const std::string& file, std::int64_t width, std::int64_t height, const ImageChoice& choice);

/// Takes the slice that is meant of `count`; InputError if it is not said or not there.
std::int64_t chosen_slice(const std::string& file, std::int64_t count, const ImageChoice& choice);

/// Turns one row (0 at the top) into whole numbers. InputError for colour, transparency, indices outside the palette,
/// numbers that do not fit 32 bits with sign.
void take_row(const PixelLayout& layout, const std::uint8_t* samples, int row, Image& image);

}  // namespace arenite::io
