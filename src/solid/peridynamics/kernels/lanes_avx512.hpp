// Sixteen floats or eight doubles at once with AVX-512; included only where the target allows it. Sums are kept in the
// four lanes and in the order of AVX2, so that both give the same bits.
#include <immintrin.h>

#include <cstdint>

namespace {

struct Doubles {
  using Scalar = double;
  static constexpr int lanes = 8;
  using Words = __m512i;
  __m512d v;
  static Doubles load(const double* p) { return {_mm512_loadu_pd(p)}; }
  static Doubles all(double c) { return {_mm512_set1_pd(c)}; }
  void store(double* p) const { _mm512_storeu_pd(p, v); }
  static Words words(const std::uint32_t* p) {
    return _mm512_cvtepu32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)));
  }
  /// Modulus by bond type, looked up by two bits of each word: the look-up takes three bits, so the four stand twice.
  struct Table {
    __m512d v;
    explicit Table(const float* four) : v(_mm512_cvtps_pd(_mm256_broadcast_ps(reinterpret_cast<const __m128*>(four)))) {}
    template <int shift>
    Doubles find(Words w) const {
      return {_mm512_permutexvar_pd(shift == 0 ? w : _mm512_srli_epi64(w, shift), v)};
    }
  };
  friend Doubles operator+(Doubles a, Doubles b) { return {_mm512_add_pd(a.v, b.v)}; }
  friend Doubles operator-(Doubles a, Doubles b) { return {_mm512_sub_pd(a.v, b.v)}; }
  friend Doubles operator*(Doubles a, Doubles b) { return {_mm512_mul_pd(a.v, b.v)}; }
  /// a b + c with one rounding; c - a b.
  friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm512_fmadd_pd(a.v, b.v, c.v)}; }
  friend Doubles fnma(Doubles a, Doubles b, Doubles c) { return {_mm512_fnmadd_pd(a.v, b.v, c.v)}; }
};

struct Floats {
  using Scalar = float;
  static constexpr int lanes = 16;
  using Words = __m512i;
  __m512 v;
  static Floats load(const float* p) { return {_mm512_loadu_ps(p)}; }
  static Floats all(float c) { return {_mm512_set1_ps(c)}; }
  void store(float* p) const { _mm512_storeu_ps(p, v); }
  static Words words(const std::uint32_t* p) { return _mm512_loadu_si512(p); }
  struct Table {
    __m512 v;
    explicit Table(const float* four) : v(_mm512_broadcast_f32x4(_mm_loadu_ps(four))) {}
    template <int shift>
    Floats find(Words w) const {
      return {_mm512_permutexvar_ps(shift == 0 ? w : _mm512_srli_epi32(w, shift), v)};
    }
  };
  friend Floats operator+(Floats a, Floats b) { return {_mm512_add_ps(a.v, b.v)}; }
  friend Floats operator-(Floats a, Floats b) { return {_mm512_sub_ps(a.v, b.v)}; }
  friend Floats operator*(Floats a, Floats b) { return {_mm512_mul_ps(a.v, b.v)}; }
  friend Floats fma(Floats a, Floats b, Floats c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
  friend Floats fnma(Floats a, Floats b, Floats c) { return {_mm512_fnmadd_ps(a.v, b.v, c.v)}; }
};

/// A sum of products a b of the two components of a plane field.
class Sum {
 public:
  void add(Doubles ax, Doubles bx, Doubles ay, Doubles by) {
    add_four(half<0>(ax), half<0>(bx), half<0>(ay), half<0>(by));
    add_four(half<1>(ax), half<1>(bx), half<1>(ay), half<1>(by));
  }
  void add(Floats ax, Floats bx, Floats ay, Floats by) {
    add_eight(_mm512_castps512_ps256(ax.v), _mm512_castps512_ps256(bx.v), _mm512_castps512_ps256(ay.v),
              _mm512_castps512_ps256(by.v));
    add_eight(_mm512_extractf32x8_ps(ax.v, 1), _mm512_extractf32x8_ps(bx.v, 1), _mm512_extractf32x8_ps(ay.v, 1),
              _mm512_extractf32x8_ps(by.v, 1));
  }
  double value() const {
    alignas(32) double p[4];
    _mm256_store_pd(p, v_);
    return (p[0] + p[1]) + (p[2] + p[3]);
  }

 private:
  template <int k>
  static __m256d half(Doubles a) {
    return _mm512_extractf64x4_pd(a.v, k);
  }
  void add_four(__m256d ax, __m256d bx, __m256d ay, __m256d by) {
    v_ = _mm256_fmadd_pd(ax, bx, _mm256_fmadd_pd(ay, by, v_));
  }
  void add_eight(__m256 ax, __m256 bx, __m256 ay, __m256 by) {
    const auto low = [](__m256 f) { return _mm256_cvtps_pd(_mm256_castps256_ps128(f)); };
    const auto high = [](__m256 f) { return _mm256_cvtps_pd(_mm256_extractf128_ps(f, 1)); };
    add_four(low(ax), low(bx), low(ay), low(by));
    add_four(high(ax), high(bx), high(ay), high(by));
  }
  __m256d v_ = _mm256_setzero_pd();
};

inline void store_rough(Doubles a, float* p) { _mm256_storeu_ps(p, _mm512_cvtpd_ps(a.v)); }
inline Doubles load_rough(const float* p) { return {_mm512_cvtps_pd(_mm256_loadu_ps(p))}; }

}  // namespace
