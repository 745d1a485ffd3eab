#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace arenite::report {

/// Where an array lies in a NumberBlock: byte offset, number of elements, type "f4", "u1", "u2", "u4" or "i4".
struct NumberRef {
  std::size_t offset = 0;
  std::size_t count = 0;
  const char* type = "f4";
};

/// Arrays of numbers as the page carries them: little-endian, the bytes of equal rank of one array side by side (which
/// lets deflate find the repeats of exponents and high bytes), all of them deflated together and written in base64.
class NumberBlock {
 public:
  NumberRef add_reals(std::span<const double> values);              ///< rounded to float32
  NumberRef add_indices(std::span<const std::uint32_t> values);     ///< in the narrowest of u1, u2, u4
  NumberRef add_integers(std::span<const std::int32_t> values);     ///< i4

  std::size_t size() const { return bytes_.size(); }
  /// The whole block as packed_text.
  std::string text() const;

 private:
  template <class T> NumberRef add(std::span<const T> values, const char* type);
  std::vector<std::uint8_t> bytes_;
};

/// Deflated (zlib) and in base64 (RFC 4648, with padding).
std::string packed_text(std::span<const std::uint8_t> bytes);
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace arenite::report
