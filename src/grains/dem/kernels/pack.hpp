#pragma once
#include <cstdint>
#include <cstring>

/// Inner functions are compiled into their loop, never on their own: a function of its own could be taken by the
/// linker for the same function of a file compiled for another processor.
#define ARENITE_INLINE inline __attribute__((always_inline))

namespace arenite::dem {

template <int W>
struct RawPack;
template <>
struct RawPack<1> {
  typedef double Numbers __attribute__((vector_size(8)));
  typedef std::int64_t Bits __attribute__((vector_size(8)));
};
template <>
struct RawPack<2> {
  typedef double Numbers __attribute__((vector_size(16)));
  typedef std::int64_t Bits __attribute__((vector_size(16)));
};
template <>
struct RawPack<4> {
  typedef double Numbers __attribute__((vector_size(32)));
  typedef std::int64_t Bits __attribute__((vector_size(32)));
};
template <>
struct RawPack<8> {
  typedef double Numbers __attribute__((vector_size(64)));
  typedef std::int64_t Bits __attribute__((vector_size(64)));
};

/// W doubles computed side by side, one contact each: the number type that the laws are written over, beside double.
/// Every operation is the exactly rounded one of a single double, so a lane's bits do not depend on W.
template <int W>
struct Pack {
  using Raw = typename RawPack<W>::Numbers;
  using Bits = typename RawPack<W>::Bits;
  Raw raw;

  Pack() = default;
  ARENITE_INLINE Pack(Raw r) : raw(r) {}
  ARENITE_INLINE explicit Pack(double a) : raw(a - Raw{}) {}  // a - 0 is a, signed zeros too

  /// W doubles from memory; no alignment asked.
  ARENITE_INLINE static Pack load(const double* p) {
    Pack a;
    std::memcpy(&a.raw, p, sizeof a.raw);
    return a;
  }
  ARENITE_INLINE void store(double* p) const { std::memcpy(p, &raw, sizeof raw); }

  ARENITE_INLINE friend Pack operator+(Pack a, Pack b) { return a.raw + b.raw; }
  ARENITE_INLINE friend Pack operator-(Pack a, Pack b) { return a.raw - b.raw; }
  ARENITE_INLINE friend Pack operator*(Pack a, Pack b) { return a.raw * b.raw; }
  ARENITE_INLINE friend Pack operator/(Pack a, Pack b) { return a.raw / b.raw; }
  ARENITE_INLINE friend Bits operator>(Pack a, Pack b) { return a.raw > b.raw; }
  ARENITE_INLINE friend Bits operator<=(Pack a, Pack b) { return a.raw <= b.raw; }
  ARENITE_INLINE friend Pack min(Pack a, Pack b) { return b.raw < a.raw ? b.raw : a.raw; }
  ARENITE_INLINE friend Pack max(Pack a, Pack b) { return a.raw < b.raw ? b.raw : a.raw; }
  ARENITE_INLINE friend Pack select(Bits condition, Pack yes, Pack no) { return condition ? yes.raw : no.raw; }
  ARENITE_INLINE friend Pack sqrt(Pack a) {
    Raw root;
    for (int k = 0; k < W; ++k) root[k] = __builtin_sqrt(a.raw[k]);
    return root;
  }
};

}  // namespace arenite::dem
