#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/image.hpp"

namespace arenite::io {

/// Which picture of a file is meant, and how large it may be.
struct ImageChoice {
  std::optional<std::int64_t> slice = {};       ///< of a stack, from 0; a file with one slice needs none
  std::string dataset = {};                     ///< of an HDF5 file; empty: the only one that can be meant
  std::int64_t most_pixels = 100'000'000;  ///< larger ones are refused before memory is asked for
};

/// Names of the formats that can be read, for help texts: "png", "tiff", "hdf5". The content decides, not the name.
std::vector<std::string> image_formats();

/// A grey picture with 1 to 32 bits a pixel, its stored values unchanged. Colour is accepted where red, green and blue
/// are equal, a palette where its entries are grey (the pixel is then what it shows), transparency where there is none;
/// otherwise InputError, as for a file that is no picture, is cut short or too large.
Image read_image(const std::filesystem::path& path, const ImageChoice& choice = {});

/// The same from the bytes of a file of this name.
Image decode_image(const std::string& bytes, const std::string& file, const ImageChoice& choice = {});

}  // namespace arenite::io
