#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/disk/byte_source.hpp"
#include "io/formats.hpp"
#include "model/image.hpp"

namespace arenite::io {

/// What of a coloured pixel is its value. `none` insists on grey; otherwise a grey pixel is taken as it is.
enum class Channel : std::uint8_t {
  none,
  red,
  green,
  blue,
  mean,
  grey
};  ///< grey: 0.299 red + 0.587 green + 0.114 blue

/// Which picture of a file is meant, and how large it may be.
struct ImageChoice {
  std::optional<std::int64_t> slice = {};  ///< of a stack, from 0; a file with one slice needs none
  std::string dataset = {};                ///< of an HDF5 file; empty: the only one that can be meant
  Channel channel = Channel::none;
  std::int64_t most_pixels = 100'000'000;  ///< larger ones are refused before memory is asked for
};

/// A grey picture with 1 to 32 bits a pixel, its stored values unchanged. Without a channel, colour is accepted where
/// red, green and blue are equal, a palette where its entries are grey (the pixel is then what it shows), and what
/// blurs values across edges not at all; with one, any colour. Transparency is accepted where there is none; otherwise
/// InputError, as for a file that is no picture, is cut short or too large.
Image read_image(const std::filesystem::path& path, const ImageChoice& choice = {});

/// The same from the bytes of a file of this name.
Image decode_image(const std::string& bytes, const std::string& file, const ImageChoice& choice = {});

/// The formats that can be read, for a sentence: "PNG, TIFF, .."; all, or those whose values are exact.
std::string picture_formats(bool exact = false);

/// How a format is known and read.
struct PictureFormat {
  std::string_view name, sentence;
  Statements states = {};
  bool has_datasets = false;  ///< may hold several pictures, of which ImageChoice::dataset names one
  bool blurs = false;         ///< values across edges: not for phases, so it is read only where a channel is chosen
  bool (*is)(std::string_view bytes);
  Image (*read)(const std::string& bytes, const std::string& file, const ImageChoice& choice);
};
namespace pictures {
ARENITE_FAMILY(PictureFormat, ARENITE_PICTURE_FORMATS)
}

/// How the samples of a row of pixels lie in memory, in this machine's byte order.
struct PixelLayout {
  std::string file;  ///< for messages
  int width = 0, height = 0;
  int bits = 8;     ///< of a sample; what has less than 8 lies in a byte of its own
  int samples = 1;  ///< of a pixel; the first is grey or an index of the palette, or the first three are a colour
  bool colour = false, opacity = false, inverted = false, is_signed = false;  ///< opacity: the last sample
  bool is_floating = false;                                                   ///< 32 or 64 bits
  Channel channel = Channel::none;                    ///< what is taken of a colour; none: colour is refused
  std::vector<std::array<std::uint16_t, 3>> palette;  ///< empty: none
  std::vector<std::array<std::int64_t, 3>> clear;     ///< samples that stand for a transparent pixel, colour or first

  std::size_t bytes_a_row() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(samples) * static_cast<std::size_t>(bits / 8);
  }
};

/// An image of no pixels or more than are allowed is an InputError.
void check_size(const std::string& file, std::int64_t width, std::int64_t height, const ImageChoice& choice);

/// Takes the slice that is meant of `count`; InputError if it is not said or not there.
std::int64_t chosen_slice(const std::string& file, std::int64_t count, const ImageChoice& choice);

/// An image of this size whose values are still to be taken.
Image empty_image(const PixelLayout& layout);

/// An image of rows of samples that lie `stride` bytes apart.
Image image_of(const PixelLayout& layout, const std::vector<std::uint8_t>& samples, std::size_t stride);

/// Turns `count` pixels of one row (0 at the top) from column x on into whole numbers. InputError for colour,
/// transparency, indices outside the palette, numbers that do not fit 32 bits with sign.
void take_row(const PixelLayout& layout, const std::uint8_t* samples, std::size_t x, std::size_t row, std::size_t count,
              Image& image);

/// The same for floating numbers, which must be whole.
void take_floating_row(const PixelLayout& layout, const std::uint8_t* samples, std::size_t x, std::size_t row,
                       std::size_t count, Image& image);

/// A floating number that is a whole one, as labels and phases are. InputError for any other.
std::int32_t whole_value(double value, const std::string& file, std::size_t x, std::size_t row);

/// A picture in colour: red, green, blue of 8 bits, row by row from the top left.
struct ColourPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 a pixel
};

/// Writes a PNG file beside and renames it. Throws InputError where the file cannot be written.
void write_png(const std::filesystem::path& path, const ColourPicture& picture);

}  // namespace arenite::io
