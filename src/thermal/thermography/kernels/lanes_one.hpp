// One number at a time: what is left over at the end of a row of lanes, and machines without lanes.
#include <cmath>
#include <cstdint>

namespace {

template <class T>
struct One {
  static constexpr std::size_t lanes = 1;
  T v;
  static One load(const float* p) { return {static_cast<T>(*p)}; }
  static One load(const std::uint16_t* p) { return {static_cast<T>(*p)}; }
  static One all(T c) { return {c}; }
  void store(T* p) const { *p = v; }
  friend One operator+(One a, One b) { return {a.v + b.v}; }
  friend One operator-(One a, One b) { return {a.v - b.v}; }
#if defined(__FMA__)
  friend One fma(One a, One b, One c) { return {std::fma(a.v, b.v, c.v)}; }
#else
  friend One fma(One a, One b, One c) { return {a.v * b.v + c.v}; }
#endif
};

}  // namespace
