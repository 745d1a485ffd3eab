#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace arenite::io {

/// What a chunk of an HDF5 table was passed through before it was stored, in this order.
struct Hdf5Filter {
  enum class Kind { deflate, shuffle, checksum } kind = Kind::deflate;
  std::size_t element = 1;  ///< bytes of a number that is shuffled
};

/// The bytes of a chunk as they were before these filters, without those whose bit is set in `skipped`. Nothing unless
/// this is exactly `size` bytes and a checksum is right.
std::optional<std::string> unpack_chunk(std::string stored, const std::vector<Hdf5Filter>& filters, unsigned skipped, std::size_t size);

}  // namespace arenite::io
