#include "solid/peridynamics/kernels/passes.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include <immintrin.h>
#endif

namespace arenite::peridynamics {

extern const KernelSet* const avx512_kernels;

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
namespace {

/// Vectors of 64 bytes. Sums are kept in the four lanes and in the order of AVX2, so that both give the same bits.
struct Avx512 {
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
  /// Modulus by bond type, looked up by two bits of each word: the look-up takes three or four bits, so the four stand
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

const KernelSet set = kernel_set<Avx512>("avx512");

}  // namespace
const KernelSet* const avx512_kernels = &set;
#else
const KernelSet* const avx512_kernels = nullptr;
#endif

}  // namespace arenite::peridynamics
