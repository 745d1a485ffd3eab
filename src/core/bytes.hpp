#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/error.hpp"
#include "core/vec.hpp"

/// States as bytes of this machine, for checkpoints and between processes. Both archives are called with each member in
/// turn, so that one list of members serves both ways.
namespace arenite {

/// Values whose bytes are all theirs: what stands in the gaps of a record is nobody's and differs from run to run.
template <class T> inline constexpr bool without_gaps = std::is_arithmetic_v<T>;
template <int D, class V> inline constexpr bool without_gaps<Vec<D, V>> = without_gaps<V>;
template <class T, std::size_t n> inline constexpr bool without_gaps<std::array<T, n>> = without_gaps<T>;

/// A vector of such values, or a text.
template <class T>
concept PlainValues = without_gaps<typename T::value_type>;

class ByteWriter {
 public:
  template <class T> void operator()(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    put(&value, sizeof(T));
  }
  template <PlainValues T> void operator()(const T& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    put(values.data(), values.size() * sizeof(typename T::value_type));
  }
  std::vector<std::uint8_t> bytes;

 private:
  void put(const void* from, std::size_t size) {
    const auto* raw = static_cast<const std::uint8_t*>(from);
    bytes.insert(bytes.end(), raw, raw + size);
  }
};

/// Throws InputError where the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
  template <class T> void operator()(T& value) {
    static_assert(std::is_arithmetic_v<T>);
    take(&value, sizeof(T));
  }
  template <PlainValues T> void operator()(T& values) {
    std::uint64_t size = 0;
    (*this)(size);
    if (size > left() / sizeof(typename T::value_type)) fail();
    values.resize(size);
    take(values.data(), size * sizeof(typename T::value_type));
  }
  std::size_t left() const { return bytes_.size() - at_; }
  bool at_end() const { return left() == 0; }
  [[noreturn]] static void fail() {
    throw InputError("the stored state is cut short or damaged; run the stage again from its start");
  }

 private:
  void take(void* target, std::size_t size) {
    if (size > left()) fail();
    if (size > 0) std::memcpy(target, bytes_.data() + at_, size);
    at_ += size;
  }
  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
};

}  // namespace arenite
