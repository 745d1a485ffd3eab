#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace arenite::io {

/// A picture in colour: red, green, blue of 8 bits, row by row from the top left.
struct ColourPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 a pixel
};

/// Writes a PNG file beside and renames it. Throws InputError where the file cannot be written.
void write_png(const std::filesystem::path& path, const ColourPicture& picture);

}  // namespace arenite::io
