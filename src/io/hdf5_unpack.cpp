#include "io/hdf5_unpack.hpp"

#include <zlib.h>

#include <cstdint>
#include <limits>

namespace arenite::io {
namespace {

/// A checksum behind the bytes may still follow.
constexpr std::size_t slack = 16;

bool inflate_to(std::string& bytes, std::size_t most) {
  std::string plain(most, '\0');
  if (bytes.size() > std::numeric_limits<uInt>::max() || most > std::numeric_limits<uInt>::max()) return false;
  uLongf length = most;
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
  if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &length, from, static_cast<uLong>(bytes.size())) != Z_OK) return false;
  plain.resize(length);
  bytes = std::move(plain);
  return true;
}

/// First bytes of all numbers come first, then their second bytes; what is no whole number is left at the end.
void unshuffle(std::string& bytes, std::size_t element) {
  const std::size_t count = bytes.size() / element;
  std::string plain = bytes;
  for (std::size_t b = 0; b < element; ++b)
    for (std::size_t i = 0; i < count; ++i) plain[i * element + b] = bytes[b * count + i];
  bytes = std::move(plain);
}

/// Fletcher's sums of 16-bit words, first byte high, in arithmetic modulo 65535 where 65535 stays as it is.
std::uint32_t fletcher(const std::string& bytes, std::size_t size) {
  const auto fold = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
  std::uint32_t first = 0, second = 0;
  for (std::size_t i = 0; i < size; i += 2) {
    const std::uint32_t high = static_cast<std::uint8_t>(bytes[i]), low = i + 1 < size ? static_cast<std::uint8_t>(bytes[i + 1]) : 0;
    first = fold(first + (high << 8 | low));
    second = fold(second + first);
  }
  return second << 16 | first;
}

bool take_checksum(std::string& bytes) {
  if (bytes.size() < 4) return false;
  const std::size_t size = bytes.size() - 4;
  std::uint32_t stored = 0;
  for (std::size_t b = 0; b < 4; ++b) stored |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(bytes[size + b])) << 8 * b;
  if (stored != fletcher(bytes, size)) return false;
  bytes.resize(size);
  return true;
}

}  // namespace

std::optional<std::string> unpack_chunk(std::string stored, const std::vector<Hdf5Filter>& filters, unsigned skipped, std::size_t size) {
  for (std::size_t i = filters.size(); i-- > 0;) {
    if (i < 32 && (skipped >> i & 1) != 0) continue;
    const Hdf5Filter& filter = filters[i];
    if (filter.kind == Hdf5Filter::Kind::shuffle) unshuffle(stored, filter.element);
    else if (!(filter.kind == Hdf5Filter::Kind::deflate ? inflate_to(stored, size + slack) : take_checksum(stored))) return std::nullopt;
  }
  if (stored.size() != size) return std::nullopt;
  return stored;
}

}  // namespace arenite::io
