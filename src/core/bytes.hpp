#pragma once
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/error.hpp"

/// States as bytes of this machine, for checkpoints. Both archives are called with each member in turn, so that one list of members serves both ways.
namespace arenite {

class ByteWriter {
 public:
  template <class T> void operator()(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    put(&value, sizeof(T));
  }
  template <class T> void operator()(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    (*this)(static_cast<std::uint64_t>(values.size()));
    put(values.data(), values.size() * sizeof(T));
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
  template <class T> void operator()(std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::uint64_t size = 0;
    (*this)(size);
    if (size > left() / sizeof(T)) fail();
    values.resize(size);
    take(values.data(), size * sizeof(T));
  }
  std::size_t left() const { return bytes_.size() - at_; }
  bool at_end() const { return left() == 0; }
  [[noreturn]] static void fail() { throw InputError("the stored state is cut short or damaged; run the stage again from its start"); }

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
