#pragma once
#include <array>
#include <cstring>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "core/lanes.hpp"
#include "core/vec.hpp"

namespace arenite::dem {

/// W contacts or grains at a time: the number type that the laws are written over, beside double.
template <int W> using Pack = Lanes<double, W>;

template <int W, int D>
ARENITE_INLINE Vec<D, Pack<W>> select(typename Pack<W>::Truths condition, Vec<D, Pack<W>> yes, Vec<D, Pack<W>> no) {
  return by_axis<D>([&](int axis) { return select(condition, yes[axis], no[axis]); });
}

/// Two and four neighbouring doubles, the pieces in which records are read and written.
using Piece = Vector<double, 2>;
using Row = Vector<double, 4>;

template <class Numbers> ARENITE_INLINE Numbers load_piece(const double* p) {
  Numbers a;
  std::memcpy(&a, p, sizeof a);
  return a;
}

template <int W = 8> ARENITE_INLINE typename Pack<W>::V side_by_side(Row low, Row high) {
#ifdef __AVX512F__  // the shuffle below as one instruction; GCC 12 makes six of it
  return _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(low), high, 1);
#else
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}

/// piece(first), piece(first + 2), ..., of W records, side by side.
template <int W, class PieceOf> ARENITE_INLINE typename Pack<W>::V every_second(int first, PieceOf&& piece) {
  if constexpr (W == 2) {
    return piece(first);
  } else if constexpr (W == 4) {
    return __builtin_shufflevector(piece(first), piece(first + 2), 0, 1, 2, 3);
  } else {
    return side_by_side(every_second<4>(first, piece), every_second<4>(first + 4, piece));
  }
}

/// First and second numbers of a's and b's pieces in turn: a0 b0 a1 b1 ...
template <int W> ARENITE_INLINE Pack<W> first_numbers(typename Pack<W>::V a, typename Pack<W>::V b) {
  if constexpr (W == 2) return __builtin_shufflevector(a, b, 0, 2);
  if constexpr (W == 4) return __builtin_shufflevector(a, b, 0, 4, 2, 6);
  if constexpr (W == 8) return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
template <int W> ARENITE_INLINE Pack<W> second_numbers(typename Pack<W>::V a, typename Pack<W>::V b) {
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
  sort_pieces<W>([&](int k) { return load_piece<Piece>(address(k)); }, first, second);
}

template <int W, class Address> ARENITE_INLINE void gather(Address&& address, Vec<2, Pack<W>>& vector) {
  gather<W>(address, vector.x, vector.y);
}

/// Pieces of t and of u that stand first, and those that stand second, in pairs of pieces.
template <int W> ARENITE_INLINE Pack<W> first_pieces(Pack<W> t, Pack<W> u) {
  if constexpr (W == 4) return __builtin_shufflevector(t.v, u.v, 0, 1, 4, 5);
  if constexpr (W == 8) return __builtin_shufflevector(t.v, u.v, 0, 1, 4, 5, 8, 9, 12, 13);
}
template <int W> ARENITE_INLINE Pack<W> second_pieces(Pack<W> t, Pack<W> u) {
  if constexpr (W == 4) return __builtin_shufflevector(t.v, u.v, 2, 3, 6, 7);
  if constexpr (W == 8) return __builtin_shufflevector(t.v, u.v, 2, 3, 6, 7, 10, 11, 14, 15);
}

/// Reads four neighbouring doubles at address(0), ..., address(W - 1) into one pack each: half of the shuffles that two
/// times two would take.
template <int W, class Address>
ARENITE_INLINE void gather(Address&& address, Pack<W>& a, Pack<W>& b, Pack<W>& c, Pack<W>& d) {
  if constexpr (W < 4) {
    gather<W>(address, a, b);
    gather<W>([&](int k) { return address(k) + 2; }, c, d);
  } else {
    const auto rows = [&](int k) {  // in the order in which first_pieces and second_pieces set them
      if constexpr (W == 4) return load_piece<Row>(address(k));
      else return side_by_side(load_piece<Row>(address(k + k / 2 * 2)), load_piece<Row>(address(k + k / 2 * 2 + 2)));
    };
    const auto r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
    const Pack<W> even = first_numbers<W>(r0, r1), odd = second_numbers<W>(r0, r1),
                  even_behind = first_numbers<W>(r2, r3), odd_behind = second_numbers<W>(r2, r3);
    a = first_pieces<W>(even, even_behind);
    b = first_pieces<W>(odd, odd_behind);
    c = second_pieces<W>(even, even_behind);
    d = second_pieces<W>(odd, odd_behind);
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
    address(0)[0] = first.v[0];
    address(0)[1] = second.v[0];
  } else {
    const auto even = first_numbers<W>(first.v, second.v).v, odd = second_numbers<W>(first.v, second.v).v;
#pragma GCC unroll 4
    for (int k = 0; k < W; k += 2) {
      std::memcpy(address(k), reinterpret_cast<const double*>(&even) + k, sizeof(Piece));
      std::memcpy(address(k + 1), reinterpret_cast<const double*>(&odd) + k, sizeof(Piece));
    }
  }
}

/// Writes rows of four: the inverse of gather.
template <int W, class Address>
ARENITE_INLINE void scatter(Address&& address, Pack<W> a, Pack<W> b, Pack<W> c, Pack<W> d) {
  if constexpr (W < 4) {
    scatter<W>(address, a, b);
    scatter<W>([&](int k) { return address(k) + 2; }, c, d);
  } else {
    const auto write = [&](int k, Row row) { std::memcpy(address(k), &row, sizeof row); };
    const auto write_every_second = [&](int k, Pack<W> ab, Pack<W> cd) {
      if constexpr (W == 4) {
        write(k, first_pieces<4>(ab, cd).v);
        write(k + 2, second_pieces<4>(ab, cd).v);
      } else {
        const auto low = __builtin_shufflevector(ab.v, cd.v, 0, 1, 8, 9, 2, 3, 10, 11),
                   high = __builtin_shufflevector(ab.v, cd.v, 4, 5, 12, 13, 6, 7, 14, 15);
        write(k, __builtin_shufflevector(low, low, 0, 1, 2, 3));
        write(k + 2, __builtin_shufflevector(low, low, 4, 5, 6, 7));
        write(k + 4, __builtin_shufflevector(high, high, 0, 1, 2, 3));
        write(k + 6, __builtin_shufflevector(high, high, 4, 5, 6, 7));
      }
    };
    write_every_second(0, first_numbers<W>(a.v, b.v), first_numbers<W>(c.v, d.v));
    write_every_second(1, second_numbers<W>(a.v, b.v), second_numbers<W>(c.v, d.v));
  }
}

}  // namespace arenite::dem
