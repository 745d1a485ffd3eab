#include "thermal/thermography/kernels/kernels.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>

#include "thermal/thermography/kernels/passes.hpp"

namespace arenite::thermography {
namespace {

/// Eight floats or four doubles at once with AVX2 and FMA.
struct Floats {
  static constexpr std::size_t lanes = 8;
  __m256 v;
  static Floats load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static Floats load(const std::uint16_t* p) { return {_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))))}; }
  static Floats all(float c) { return {_mm256_set1_ps(c)}; }
  void store(float* p) const { _mm256_storeu_ps(p, v); }
  friend Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }
  friend Floats operator-(Floats a, Floats b) { return {_mm256_sub_ps(a.v, b.v)}; }
  friend Floats fma(Floats a, Floats b, Floats c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
};

struct Doubles {
  static constexpr std::size_t lanes = 4;
  __m256d v;
  static Doubles load(const float* p) { return {_mm256_cvtps_pd(_mm_loadu_ps(p))}; }
  static Doubles all(double c) { return {_mm256_set1_pd(c)}; }
  void store(double* p) const { _mm256_storeu_pd(p, v); }
  friend Doubles operator+(Doubles a, Doubles b) { return {_mm256_add_pd(a.v, b.v)}; }
  friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm256_fmadd_pd(a.v, b.v, c.v)}; }
};

constexpr Kernels table = table_of<Floats, Doubles>("avx2");

}  // namespace

const Kernels* const avx2_kernels = &table;

}  // namespace arenite::thermography
#else
const arenite::thermography::Kernels* const arenite::thermography::avx2_kernels = nullptr;
#endif
