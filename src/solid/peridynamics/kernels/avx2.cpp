#include "solid/peridynamics/kernels/passes.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#endif

namespace arenite::peridynamics {

extern const KernelSet* const avx2_kernels;

#if defined(__AVX2__) && defined(__FMA__)
namespace {

/// Vectors of 32 bytes.
struct Avx2 {
  static constexpr int bytes = 32, sum_lanes = 4;
  template <std::size_t k> static __m256d doubles(__m256d a) { return a; }
  template <std::size_t k> static __m256d doubles(__m256 a) { return _mm256_cvtps_pd(_mm256_extractf128_ps(a, k)); }
  template <int lanes> struct Words {
    Vector<std::int32_t, lanes> w;
    explicit Words(const std::uint32_t* p) { std::memcpy(&w, p, sizeof w); }
  };
  /// Modulus by bond type: one of four floats, looked up by two bits of each word.
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

const KernelSet set = kernel_set<Avx2>("avx2");

}  // namespace
const KernelSet* const avx2_kernels = &set;
#else
const KernelSet* const avx2_kernels = nullptr;
#endif

}  // namespace arenite::peridynamics
