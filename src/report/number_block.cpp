#include "report/number_block.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace arenite::report {

static_assert(std::endian::native == std::endian::little, "the block's bytes are written as they lie in memory");

template <class T>
NumberRef NumberBlock::add(std::span<const T> values, const char* type) {
  const NumberRef ref{bytes_.size(), values.size(), type};
  bytes_.resize(bytes_.size() + values.size_bytes());
  const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
  std::uint8_t* to = bytes_.data() + ref.offset;
  for (std::size_t rank = 0; rank < sizeof(T); ++rank)
    for (std::size_t k = 0; k < values.size(); ++k) *to++ = from[k * sizeof(T) + rank];
  return ref;
}

NumberRef NumberBlock::add_reals(std::span<const double> values) {
  const std::vector<float> narrow(values.begin(), values.end());
  return add<float>(narrow, "f4");
}

NumberRef NumberBlock::add_indices(std::span<const std::uint32_t> values) {
  const std::uint32_t largest = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  if (largest < 0x100) {
    const std::vector<std::uint8_t> narrow(values.begin(), values.end());
    return add<std::uint8_t>(narrow, "u1");
  }
  if (largest < 0x10000) {
    const std::vector<std::uint16_t> narrow(values.begin(), values.end());
    return add<std::uint16_t>(narrow, "u2");
  }
  return add<std::uint32_t>(values, "u4");
}

NumberRef NumberBlock::add_integers(std::span<const std::int32_t> values) { return add<std::int32_t>(values, "i4"); }

std::string NumberBlock::text() const { return packed_text(bytes_); }

std::string packed_text(std::span<const std::uint8_t> bytes) {
  uLongf length = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::uint8_t> packed(length);
  const int status = compress2(packed.data(), &length, bytes.data(), static_cast<uLong>(bytes.size()), 6);
  if (status != Z_OK) throw std::runtime_error("zlib could not compress the page's numbers");
  packed.resize(length);
  return base64(packed);
}

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t triple = static_cast<std::uint32_t>(bytes[k]) << 16;
    if (left > 1) triple |= static_cast<std::uint32_t>(bytes[k + 1]) << 8;
    if (left > 2) triple |= bytes[k + 2];
    text += digits[triple >> 18];
    text += digits[(triple >> 12) & 63];
    text += left > 1 ? digits[(triple >> 6) & 63] : '=';
    text += left > 2 ? digits[triple & 63] : '=';
  }
  return text;
}

}  // namespace arenite::report
