#include "thermal/thermography/kernels/kernels.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include <immintrin.h>

#include "thermal/thermography/kernels/passes.hpp"

namespace arenite::thermography {
namespace {

/// Sixteen floats or eight doubles at once with AVX-512.
struct Floats {
  static constexpr std::size_t lanes = 16;
  __m512 v;
  static Floats load(const float* p) { return {_mm512_loadu_ps(p)}; }
  static Floats load(const std::uint16_t* p) { return {_mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))))}; }
  static Floats all(float c) { return {_mm512_set1_ps(c)}; }
  void store(float* p) const { _mm512_storeu_ps(p, v); }
  friend Floats operator+(Floats a, Floats b) { return {_mm512_add_ps(a.v, b.v)}; }
  friend Floats operator-(Floats a, Floats b) { return {_mm512_sub_ps(a.v, b.v)}; }
  friend Floats fma(Floats a, Floats b, Floats c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
};

struct Doubles {
  static constexpr std::size_t lanes = 8;
  __m512d v;
  static Doubles load(const float* p) { return {_mm512_cvtps_pd(_mm256_loadu_ps(p))}; }
  static Doubles all(double c) { return {_mm512_set1_pd(c)}; }
  void store(double* p) const { _mm512_storeu_pd(p, v); }
  friend Doubles operator+(Doubles a, Doubles b) { return {_mm512_add_pd(a.v, b.v)}; }
  friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm512_fmadd_pd(a.v, b.v, c.v)}; }
};

constexpr Kernels table = table_of<Floats, Doubles>("avx512");

}  // namespace

const Kernels* const avx512_kernels = &table;

}  // namespace arenite::thermography
#else
const arenite::thermography::Kernels* const arenite::thermography::avx512_kernels = nullptr;
#endif
