#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "core/vec.hpp"

/// Inner functions are compiled into their loop, never on their own: a function of its own could be taken by the linker
/// for the same function of a file compiled for another processor.
#define ARENITE_INLINE inline __attribute__((always_inline))

namespace arenite::dem {

template <int W> struct RawPack {
  typedef double Numbers __attribute__((vector_size(8 * W)));
  typedef std::int64_t Bits __attribute__((vector_size(8 * W)));
};

/// W doubles computed side by side, one contact each: the number type that the laws are written over, beside double.
/// Every operation is the exactly rounded one of a single double, so a lane's bits do not depend on W.
template <int W> struct Pack {
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
  ARENITE_INLINE friend Pack operator-(Pack a) { return -a.raw; }
  ARENITE_INLINE friend Pack operator*(Pack a, Pack b) { return a.raw * b.raw; }
  ARENITE_INLINE friend Pack operator/(Pack a, Pack b) { return a.raw / b.raw; }
  ARENITE_INLINE friend Bits operator>(Pack a, Pack b) { return a.raw > b.raw; }
  ARENITE_INLINE friend Bits operator<=(Pack a, Pack b) { return a.raw <= b.raw; }
  ARENITE_INLINE friend Pack min(Pack a, Pack b) { return b.raw < a.raw ? b.raw : a.raw; }
  ARENITE_INLINE friend Pack max(Pack a, Pack b) { return a.raw < b.raw ? b.raw : a.raw; }
  ARENITE_INLINE friend Pack abs(Pack a) { return max(a, Pack(0.0) - a); }
  ARENITE_INLINE friend Pack dot(Pack a, Pack b) { return a.raw * b.raw; }
  ARENITE_INLINE friend Pack select(Bits condition, Pack yes, Pack no) { return condition ? yes.raw : no.raw; }
  ARENITE_INLINE friend Pack sqrt(Pack a) {
    Raw root;
    for (int k = 0; k < W; ++k) root[k] = __builtin_sqrt(a.raw[k]);
    return root;
  }
};

template <int W, int D>
ARENITE_INLINE Vec<D, Pack<W>> select(typename Pack<W>::Bits condition, Vec<D, Pack<W>> yes, Vec<D, Pack<W>> no) {
  return by_axis<D>([&](int axis) { return select(condition, yes[axis], no[axis]); });
}

/// Two neighbouring doubles, the piece in which records are read and written.
using Piece = RawPack<2>::Numbers;

ARENITE_INLINE Piece load_piece(const double* p) {
  Piece a;
  std::memcpy(&a, p, sizeof a);
  return a;
}

/// piece(first), piece(first + 2), ..., of W records, side by side.
template <int W, class PieceOf> ARENITE_INLINE typename Pack<W>::Raw every_second(int first, PieceOf&& piece) {
  if constexpr (W == 2) {
    return piece(first);
  } else if constexpr (W == 4) {
    return __builtin_shufflevector(piece(first), piece(first + 2), 0, 1, 2, 3);
  } else {
    const auto low = every_second<4>(first, piece), high = every_second<4>(first + 4, piece);
#ifdef __AVX512F__  // the shuffle below as one instruction; GCC 12 makes six of it
    return _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(low), high, 1);
#else
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
  }
}

/// First and second numbers of a's and b's pieces in turn: a0 b0 a1 b1 ...
template <int W> ARENITE_INLINE Pack<W> first_numbers(typename Pack<W>::Raw a, typename Pack<W>::Raw b) {
  if constexpr (W == 2) return __builtin_shufflevector(a, b, 0, 2);
  if constexpr (W == 4) return __builtin_shufflevector(a, b, 0, 4, 2, 6);
  if constexpr (W == 8) return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
template <int W> ARENITE_INLINE Pack<W> second_numbers(typename Pack<W>::Raw a, typename Pack<W>::Raw b) {
  if constexpr (W == 2) return __builtin_shufflevector(a, b, 1, 3);
  if constexpr (W == 4) return __builtin_shufflevector(a, b, 1, 5, 3, 7);
  if constexpr (W == 8) return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}

/// Sorts piece(0), ..., piece(W - 1) into a pack of their first and one of their second numbers.
template <int W, class PieceOf> ARENITE_INLINE void sort_pieces(PieceOf&& piece, Pack<W>& first, Pack<W>& second) {
  if constexpr (W == 1) {
    first = Pack<W>(piece(0)[0]);
    second = Pack<W>(piece(0)[1]);
  } else {
    const auto even = every_second<W>(0, piece), odd = every_second<W>(1, piece);
    first = first_numbers<W>(even, odd);
    second = second_numbers<W>(even, odd);
  }
}

/// Reads two neighbouring doubles at address(0), ..., address(W - 1) into one pack each.
template <int W, class Address> ARENITE_INLINE void gather(Address&& address, Pack<W>& first, Pack<W>& second) {
  sort_pieces<W>([&](int k) { return load_piece(address(k)); }, first, second);
}

/// The same of a vector. In space the double behind it is read as well.
template <int W, int D, class Address> ARENITE_INLINE void gather(Address&& address, Vec<D, Pack<W>>& vector) {
  gather<W>(address, vector.x, vector.y);
  if constexpr (D == 3) {
    Pack<W> behind;
    gather<W>([&](int k) { return address(k) + 2; }, vector.z, behind);
  }
}

/// Reads and writes vectors that lie in one array a component, or the numbers of one array.
template <int W, class Number, std::size_t N>
ARENITE_INLINE auto load_columns(const std::array<Number*, N>& from, std::size_t k) {
  if constexpr (N == 1) return Pack<W>::load(from[0] + k);
  else return by_axis<N>([&](int axis) { return Pack<W>::load(from[axis] + k); });
}
template <int W> ARENITE_INLINE void store_columns(Pack<W> numbers, const std::array<double*, 1>& to, std::size_t k) {
  numbers.store(to[0] + k);
}
template <int W, int D>
ARENITE_INLINE void store_columns(Vec<D, Pack<W>> vector, const std::array<double*, static_cast<std::size_t>(D)>& to,
                                  std::size_t k) {
#pragma GCC unroll 3
  for (int axis = 0; axis < D; ++axis) vector[axis].store(to[axis] + k);
}

/// The inverse of gather.
template <int W, class Address> ARENITE_INLINE void scatter(Address&& address, Pack<W> first, Pack<W> second) {
  if constexpr (W == 1) {
    address(0)[0] = first.raw[0];
    address(0)[1] = second.raw[0];
  } else {
    const auto even = first_numbers<W>(first.raw, second.raw).raw, odd = second_numbers<W>(first.raw, second.raw).raw;
#pragma GCC unroll 4
    for (int k = 0; k < W; k += 2) {
      std::memcpy(address(k), reinterpret_cast<const double*>(&even) + k, sizeof(Piece));
      std::memcpy(address(k + 1), reinterpret_cast<const double*>(&odd) + k, sizeof(Piece));
    }
  }
}

/// The same of a vector. In space that is number by number, for nothing of a record lies behind it that may be
/// overwritten.
template <int W, int D, class Address> ARENITE_INLINE void scatter(Address&& address, Vec<D, Pack<W>> vector) {
  scatter<W>(address, vector.x, vector.y);
  if constexpr (D == 3)
    for (int k = 0; k < W; ++k) address(k)[2] = vector.z.raw[k];
}

}  // namespace arenite::dem
