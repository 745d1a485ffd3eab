#pragma once
#include <concepts>
#include <cstdint>
#include <cstring>
#ifdef __AVX2__
#include <immintrin.h>
#endif

/// Inner functions are compiled into their loop, never on their own: a function of its own could be taken by the linker
/// for the same function of a file compiled for another processor.
#define ARENITE_INLINE inline __attribute__((always_inline))

namespace arenite {

/// The compiler's own vector of n numbers.
template <class T, int n> struct VectorOf { typedef T type __attribute__((vector_size(n * sizeof(T)))); };
template <class T, int n> using Vector = typename VectorOf<T, n>::type;

/// n numbers computed side by side: what the inner loops are written over. Every operation is the exactly rounded one
/// of a single number, so that a lane's bits do not depend on n; a b + c (`fma`) is rounded once where the processor
/// that a source is compiled for can do so, and twice elsewhere.
template <class T, int n> struct Lanes {
  using Scalar = T;
  using V = Vector<T, n>;
  using Truths = decltype(V{} < V{});  ///< what a comparison says of every lane
  static constexpr int lanes = n;
  V v;

  Lanes() = default;
  ARENITE_INLINE Lanes(V numbers) : v(numbers) {}
  ARENITE_INLINE explicit Lanes(T a) : v(a - V{}) {}  // a - 0 is a, signed zeros too

  /// n numbers from memory; no alignment asked.
  ARENITE_INLINE static Lanes load(const T* p) {
    Lanes a;
    std::memcpy(&a.v, p, sizeof a.v);
    return a;
  }
  /// Doubles that are kept in single precision.
  ARENITE_INLINE static Lanes load(const float* p) requires std::same_as<T, double> {
#ifdef __AVX512F__  // read and widened by one instruction; GCC 12 makes five of what is said below
    if constexpr (n == 8) return V(_mm512_cvtps_pd(_mm256_loadu_ps(p)));
#endif
#ifdef __AVX2__
    if constexpr (n == 4) return V(_mm256_cvtps_pd(_mm_loadu_ps(p)));
#endif
    Vector<float, n> rough;
    std::memcpy(&rough, p, sizeof rough);
    return V(__builtin_convertvector(rough, V));
  }
  /// Whole numbers of 16 bits.
  ARENITE_INLINE static Lanes load(const std::uint16_t* p) requires std::same_as<T, float> {
#ifdef __AVX512F__
    if constexpr (n == 16)
      return V(_mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)))));
#endif
#ifdef __AVX2__
    if constexpr (n == 8)
      return V(_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)))));
#endif
    Vector<std::uint16_t, n> whole;
    std::memcpy(&whole, p, sizeof whole);
    return V(__builtin_convertvector(__builtin_convertvector(whole, Vector<std::int32_t, n>), V));
  }
  ARENITE_INLINE void store(T* p) const { std::memcpy(p, &v, sizeof v); }
  /// Rounded to single precision.
  ARENITE_INLINE void store(float* p) const requires std::same_as<T, double> {
    const auto rough = __builtin_convertvector(v, Vector<float, n>);
    std::memcpy(p, &rough, sizeof rough);
  }

  ARENITE_INLINE friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  ARENITE_INLINE friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  ARENITE_INLINE friend Lanes operator-(Lanes a) { return -a.v; }
  ARENITE_INLINE friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  ARENITE_INLINE friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  ARENITE_INLINE friend Truths operator>(Lanes a, Lanes b) { return a.v > b.v; }
  ARENITE_INLINE friend Truths operator<=(Lanes a, Lanes b) { return a.v <= b.v; }
  ARENITE_INLINE friend Lanes min(Lanes a, Lanes b) { return b.v < a.v ? b.v : a.v; }
  ARENITE_INLINE friend Lanes max(Lanes a, Lanes b) { return a.v < b.v ? b.v : a.v; }
  ARENITE_INLINE friend Lanes abs(Lanes a) { return max(a, Lanes(T(0)) - a); }
  ARENITE_INLINE friend Lanes dot(Lanes a, Lanes b) { return a.v * b.v; }  // vectors of one axis
  ARENITE_INLINE friend Lanes select(Truths condition, Lanes yes, Lanes no) { return condition ? yes.v : no.v; }
  ARENITE_INLINE friend Lanes sqrt(Lanes a) {
    V root;
    for (int k = 0; k < n; ++k) root[k] = __builtin_sqrt(a.v[k]);
    return root;
  }
  /// a b + c and c - a b.
  ARENITE_INLINE friend Lanes fma(Lanes a, Lanes b, Lanes c) {
#ifdef __FMA__
    constexpr bool is_double = std::same_as<T, double>;
    Lanes sum;
#ifdef __AVX512F__
    if constexpr (sizeof(V) == 64 && is_double) sum.v = _mm512_fmadd_pd(a.v, b.v, c.v);
    else if constexpr (sizeof(V) == 64) sum.v = _mm512_fmadd_ps(a.v, b.v, c.v);
    else
#endif
        if constexpr (sizeof(V) == 32 && is_double)
      sum.v = _mm256_fmadd_pd(a.v, b.v, c.v);
    else if constexpr (sizeof(V) == 32) sum.v = _mm256_fmadd_ps(a.v, b.v, c.v);
    else if constexpr (is_double)
      for (int k = 0; k < n; ++k) sum.v[k] = __builtin_fma(a.v[k], b.v[k], c.v[k]);
    else
      for (int k = 0; k < n; ++k) sum.v[k] = __builtin_fmaf(a.v[k], b.v[k], c.v[k]);
    return sum;
#else
    return a.v * b.v + c.v;
#endif
  }
  ARENITE_INLINE friend Lanes fnma(Lanes a, Lanes b, Lanes c) { return fma(-a, b, c); }
};

}  // namespace arenite
