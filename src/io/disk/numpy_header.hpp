#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/disk/byte_source.hpp"

namespace arenite::io {

/// Whether bytes begin as a .npy array does.
bool is_numpy_array(std::string_view head);

/// What the header of a .npy array says.
struct NumpyHeader {
  std::string type;                  ///< in Python's words: "<f4"
  std::optional<NumberType> number;  ///< the same; nothing where it is none of ours
  bool big_endian = false, fortran = false;
  std::vector<std::int64_t> shape;
  std::size_t start = 0;  ///< of the numbers
};

/// Throws InputError for what is no .npy array of numbers.
NumpyHeader numpy_header_in(const Bytes& bytes);

/// A .npy file: its header, and `numbers` (their bytes, the last axis fastest) of this type, as numpy.load reads it.
std::string numpy_file(std::string_view type, const std::vector<std::int64_t>& shape, std::string_view numbers);

}  // namespace arenite::io
