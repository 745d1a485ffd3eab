#include "core/hash.hpp"

#include <fmt/core.h>
#include <xxhash.h>

#include <bit>

namespace arenite {
namespace {

/// Numbers of eight bytes, each with its lowest first.
template <class T> std::string_view bytes_of(const T* numbers, std::size_t count) {
  static_assert(std::endian::native == std::endian::little && sizeof(T) == 8);
  return {reinterpret_cast<const char*>(numbers), count * sizeof(T)};
}

}  // namespace

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

HashBuilder& HashBuilder::add(std::string_view key, std::string_view value) { return add_part('s', key, value); }
HashBuilder& HashBuilder::add(std::string_view key, double value) { return add_part('d', key, bytes_of(&value, 1)); }
HashBuilder& HashBuilder::add(std::string_view key, std::int64_t value) {
  return add_part('i', key, bytes_of(&value, 1));
}
HashBuilder& HashBuilder::add(std::string_view key, const std::vector<double>& values) {
  return add_part('a', key, bytes_of(values.data(), values.size()));
}

HashBuilder& HashBuilder::add_part(char type, std::string_view key, std::string_view bytes) {
  text_ += type;
  for (const std::string_view part : {key, bytes}) {
    const std::uint64_t size = part.size();
    text_.append(bytes_of(&size, 1)).append(part);
  }
  return *this;
}

}  // namespace arenite
