#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/disk/file.hpp"

namespace arenite::io {

/// Bytes that are read at any place: of a file, which need not fit in memory, or of a text in memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;
  /// Up to `count` bytes from `at`; fewer at the end. Throws InputError where the system refuses.
  virtual std::size_t read(std::uint64_t at, std::size_t count, void* to) const = 0;
  virtual const std::string& name() const = 0;            ///< for messages
  virtual const std::filesystem::path* path() const = 0;  ///< of a file; null for bytes in memory

  std::string text(std::uint64_t at, std::size_t count) const;
};

using Bytes = std::shared_ptr<const ByteSource>;

/// Throws InputError for a missing file, a folder, no permission.
Bytes open_bytes(const std::filesystem::path& path);
Bytes bytes_in_memory(std::string bytes, std::string name);
/// Bytes that somebody else keeps, for longer than these are used.
Bytes bytes_kept(std::string_view bytes, std::string name);

/// Beginnings by which formats of pictures and of films alike are known: TIFF and BigTIFF of either byte order, and
/// HDF5, before which 512, 1024, 2048 .. bytes of the user's may stand.
bool is_tiff(std::string_view head);
bool is_hdf5(std::string_view head);

/// How a number is stored.
enum class NumberType : std::uint8_t { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };
std::size_t bytes_of(NumberType type);
inline bool is_level(NumberType type) { return type == NumberType::u8 || type == NumberType::u16; }

static_assert(std::endian::native == std::endian::little);

/// A number of this type at a place of some bytes, lowest byte first; 0 beyond their end.
template <class T> T number_at(std::string_view bytes, std::size_t at) {
  T value{};
  if (at <= bytes.size() && bytes.size() - at >= sizeof(T)) std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

/// Puts a number into bytes, or at their end, lowest byte first.
template <class T> void put(std::string& bytes, std::size_t at, std::type_identity_t<T> value) {
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}
template <class T> void append(std::string& bytes, std::type_identity_t<T> value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <class T> T swapped(T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  std::reverse(bytes, bytes + sizeof(T));
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}
template <class T, class Take> void each_number_of(bool big_endian, const char* from, std::size_t count, Take&& take) {
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, from + i * sizeof(T), sizeof(T));
    take(i, big_endian ? swapped(value) : value);
  }
}

/// Calls `take` with place and value of every one of `count` stored numbers.
template <class Take>
void each_number(NumberType type, bool big_endian, const char* from, std::size_t count, Take&& take) {
  switch (type) {
    case NumberType::u8: return each_number_of<std::uint8_t>(false, from, count, take);
    case NumberType::i8: return each_number_of<std::int8_t>(false, from, count, take);
    case NumberType::u16: return each_number_of<std::uint16_t>(big_endian, from, count, take);
    case NumberType::i16: return each_number_of<std::int16_t>(big_endian, from, count, take);
    case NumberType::u32: return each_number_of<std::uint32_t>(big_endian, from, count, take);
    case NumberType::i32: return each_number_of<std::int32_t>(big_endian, from, count, take);
    case NumberType::u64: return each_number_of<std::uint64_t>(big_endian, from, count, take);
    case NumberType::i64: return each_number_of<std::int64_t>(big_endian, from, count, take);
    case NumberType::f32: return each_number_of<float>(big_endian, from, count, take);
    case NumberType::f64: return each_number_of<double>(big_endian, from, count, take);
  }
}

}  // namespace arenite::io
