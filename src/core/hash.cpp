#include "core/hash.hpp"

#include <xxhash.h>

#include <bit>

namespace arenite {
namespace {

/// Eight bytes, lowest first, on any machine.
std::string little_endian(std::uint64_t bits) {
  std::string bytes(8, '\0');
  for (int k = 0; k < 8; ++k) bytes[static_cast<std::size_t>(k)] = static_cast<char>((bits >> (8 * k)) & 0xff);
  return bytes;
}

}  // namespace

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint64_t half : {std::uint64_t{hash.high64}, std::uint64_t{hash.low64}})
    for (int shift = 60; shift >= 0; shift -= 4) text += digits[(half >> shift) & 0xf];
  return text;
}

HashBuilder& HashBuilder::add(std::string_view key, std::string_view value) { return add_part('s', key, value); }

HashBuilder& HashBuilder::add(std::string_view key, double value) { return add_part('d', key, little_endian(std::bit_cast<std::uint64_t>(value))); }

HashBuilder& HashBuilder::add(std::string_view key, std::int64_t value) { return add_part('i', key, little_endian(static_cast<std::uint64_t>(value))); }

HashBuilder& HashBuilder::add(std::string_view key, const std::vector<double>& values) {
  std::string bytes;
  for (const double v : values) bytes += little_endian(std::bit_cast<std::uint64_t>(v));
  return add_part('a', key, bytes);
}

HashBuilder& HashBuilder::add_part(char type, std::string_view key, std::string_view bytes) {
  text_ += type;
  text_ += little_endian(key.size());
  text_ += key;
  text_ += little_endian(bytes.size());
  text_ += bytes;
  return *this;
}

}  // namespace arenite
