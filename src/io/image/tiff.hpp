#pragma once
#include <tiffio.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "core/problems.hpp"
#include "io/disk/byte_source.hpp"

// Only the files that speak TIFF include this one.
namespace arenite::io {

/// Bytes as libtiff's file, and its first complaint about them.
struct TiffSource {
  Bytes bytes;
  std::uint64_t at = 0;
  std::string complaint;

  explicit TiffSource(Bytes from) : bytes(std::move(from)) {}
  const std::string& file() const { return bytes->name(); }
  [[noreturn]] void refuse(const std::string& message) const;  ///< InputError
  [[noreturn]] void refuse_damaged() const;
};

using Tiff = std::unique_ptr<TIFF, void (*)(TIFF*)>;

/// For reading; null for what is no TIFF. `source` must outlive it. At most `most_at_once` bytes of memory are asked
/// for in one piece, whatever a tag says.
Tiff open_tiff(TiffSource& source, std::int64_t most_at_once = std::int64_t{1} << 30);

/// For writing, from the start; null where the system refuses. libtiff's own words are not heard: it prints them.
Tiff create_tiff(const std::filesystem::path& path, bool large);

template <class T> T tiff_field(TIFF* tiff, std::uint32_t tag) {
  T value = 0;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

/// A strip or a tile of a page, as far as it lies within the page.
struct TiffBlock {
  std::size_t x = 0, y = 0, columns = 0, rows = 0;  ///< pixels of the page
  std::size_t stride = 0;                           ///< bytes from row to row
  const std::uint8_t* samples = nullptr;
  const std::uint8_t* row(std::size_t r) const { return samples + r * stride; }
};

/// Calls `see` for all of a page whose samples lie pixel by pixel, one block after the other; those of less than a byte
/// have one each. InputError for damage.
void each_block(TIFF* tiff, const TiffSource& source, const std::function<void(const TiffBlock& block)>& see);

}  // namespace arenite::io
