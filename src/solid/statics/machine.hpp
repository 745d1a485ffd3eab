// How wide the vectors of the processor are that a source is compiled for: included by sources of a kernels folder,
// which are compiled with flags of their own, and therefore without names that a linker could take from one of them for
// another.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/lanes.hpp"

namespace arenite::statics {
namespace {

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)

/// Vectors of 64 bytes. Sums are kept in the four lanes and in the order of AVX2, so that both give the same bits.
struct Machine {
  static constexpr const char* name = "avx512";
  static constexpr int bytes = 64, sum_lanes = 4;
  template <std::size_t k> static __m256d doubles(__m512d a) { return _mm512_extractf64x4_pd(a, k); }
  template <std::size_t k> static __m256d doubles(__m512 a) { return _mm256_cvtps_pd(_mm512_extractf32x4_ps(a, k)); }
  template <int lanes> struct Words {
    __m512i w;
    explicit Words(const std::uint32_t* p) {
      if constexpr (lanes == 16) w = _mm512_loadu_si512(p);
      else w = _mm512_cvtepu32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)));
    }
  };
  /// One of four numbers, looked up by two bits of each word: the look-up takes three or four bits, so the four stand
  /// several times.
  template <class L> struct Table {
    typename L::V v;
    explicit Table(const float* four) {
      if constexpr (L::lanes == 16) v = _mm512_broadcast_f32x4(_mm_loadu_ps(four));
      else v = _mm512_cvtps_pd(_mm256_broadcast_ps(reinterpret_cast<const __m128*>(four)));
    }
    template <int shift> L find(Words<L::lanes> words) const {
      if constexpr (L::lanes == 16) return {_mm512_permutexvar_ps(_mm512_srli_epi32(words.w, shift), v)};
      else return {_mm512_permutexvar_pd(_mm512_srli_epi64(words.w, shift), v)};
    }
  };
};

#elif defined(__AVX2__) && defined(__FMA__)

/// Vectors of 32 bytes.
struct Machine {
  static constexpr const char* name = "avx2";
  static constexpr int bytes = 32, sum_lanes = 4;
  template <std::size_t k> static __m256d doubles(__m256d a) { return a; }
  template <std::size_t k> static __m256d doubles(__m256 a) { return _mm256_cvtps_pd(_mm256_extractf128_ps(a, k)); }
  template <int lanes> struct Words {
    Vector<std::int32_t, lanes> w;
    explicit Words(const std::uint32_t* p) { std::memcpy(&w, p, sizeof w); }
  };
  /// One of four numbers, looked up by two bits of each word.
  template <class L> struct Table {
    __m256 v;
    explicit Table(const float* four) : v(_mm256_broadcast_ps(reinterpret_cast<const __m128*>(four))) {}
    template <int shift> L find(Words<L::lanes> words) const {
      if constexpr (L::lanes == 8) return {_mm256_permutevar_ps(v, reinterpret_cast<__m256i>(words.w >> shift))};
      else
        return {
            _mm256_cvtps_pd(_mm_permutevar_ps(_mm256_castps256_ps128(v), reinterpret_cast<__m128i>(words.w >> shift)))};
    }
  };
};

#else

/// What every x86-64 carries out: vectors of 16 bytes, products and sums rounded apart, so that the bits are the same
/// everywhere.
struct Machine {
  static constexpr const char* name = "portable";
  static constexpr int bytes = 16, sum_lanes = 2;
  template <std::size_t k> static Vector<double, 2> doubles(Vector<double, 2> a) { return a; }
  template <std::size_t k> static Vector<double, 2> doubles(Vector<float, 4> a) {
    return Vector<double, 2>{a[2 * k], a[2 * k + 1]};
  }
  template <int lanes> struct Words {
    std::uint32_t w[lanes];
    explicit Words(const std::uint32_t* p) { std::memcpy(w, p, sizeof w); }
  };
  /// One of four numbers, looked up by two bits of each word.
  template <class L> struct Table {
    typename L::Scalar four[4];
    explicit Table(const float* p) : four{p[0], p[1], p[2], p[3]} {}
    template <int shift> L find(Words<L::lanes> words) const {
      typename L::Scalar found[L::lanes];
      for (int i = 0; i < L::lanes; ++i) found[i] = four[words.w[i] >> shift & 3u];
      return L::load(found);
    }
  };
};

#endif

}  // namespace
}  // namespace arenite::statics
