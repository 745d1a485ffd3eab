// Eight floats or four doubles at once with AVX2 and FMA; included only where the target allows these.
#include <immintrin.h>

#include <cstdint>

namespace {

struct Doubles {
  using Scalar = double;
  static constexpr int lanes = 4;
  using Words = __m128i;
  __m256d v;
  static Doubles load(const double* p) { return {_mm256_loadu_pd(p)}; }
  static Doubles all(double c) { return {_mm256_set1_pd(c)}; }
  void store(double* p) const { _mm256_storeu_pd(p, v); }
  static Words words(const std::uint32_t* p) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p)); }
  /// Modulus by bond type: one of four floats, looked up by two bits of each word.
  struct Table {
    __m128 v;
    explicit Table(const float* four) : v(_mm_loadu_ps(four)) {}
    template <int shift>
    Doubles find(Words w) const {
      return {_mm256_cvtps_pd(_mm_permutevar_ps(v, shift == 0 ? w : _mm_srli_epi32(w, shift)))};
    }
  };
  friend Doubles operator+(Doubles a, Doubles b) { return {_mm256_add_pd(a.v, b.v)}; }
  friend Doubles operator-(Doubles a, Doubles b) { return {_mm256_sub_pd(a.v, b.v)}; }
  friend Doubles operator*(Doubles a, Doubles b) { return {_mm256_mul_pd(a.v, b.v)}; }
  /// a b + c with one rounding; c - a b.
  friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm256_fmadd_pd(a.v, b.v, c.v)}; }
  friend Doubles fnma(Doubles a, Doubles b, Doubles c) { return {_mm256_fnmadd_pd(a.v, b.v, c.v)}; }
};

struct Floats {
  using Scalar = float;
  static constexpr int lanes = 8;
  using Words = __m256i;
  __m256 v;
  static Floats load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static Floats all(float c) { return {_mm256_set1_ps(c)}; }
  void store(float* p) const { _mm256_storeu_ps(p, v); }
  static Words words(const std::uint32_t* p) { return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)); }
  struct Table {
    __m256 v;
    explicit Table(const float* four) : v(_mm256_broadcast_ps(reinterpret_cast<const __m128*>(four))) {}
    template <int shift>
    Floats find(Words w) const {
      return {_mm256_permutevar_ps(v, shift == 0 ? w : _mm256_srli_epi32(w, shift))};
    }
  };
  friend Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }
  friend Floats operator-(Floats a, Floats b) { return {_mm256_sub_ps(a.v, b.v)}; }
  friend Floats operator*(Floats a, Floats b) { return {_mm256_mul_ps(a.v, b.v)}; }
  friend Floats fma(Floats a, Floats b, Floats c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
  friend Floats fnma(Floats a, Floats b, Floats c) { return {_mm256_fnmadd_ps(a.v, b.v, c.v)}; }
};

/// A sum of products a b of the two components of a plane field, in four lanes of doubles.
class Sum {
 public:
  void add(Doubles ax, Doubles bx, Doubles ay, Doubles by) { v_ = fma(ax, bx, fma(ay, by, v_)); }
  void add(Floats ax, Floats bx, Floats ay, Floats by) {
    add(low(ax), low(bx), low(ay), low(by));
    add(high(ax), high(bx), high(ay), high(by));
  }
  double value() const {
    alignas(32) double p[4];
    _mm256_store_pd(p, v_.v);
    return (p[0] + p[1]) + (p[2] + p[3]);
  }

 private:
  static Doubles low(Floats f) { return {_mm256_cvtps_pd(_mm256_castps256_ps128(f.v))}; }
  static Doubles high(Floats f) { return {_mm256_cvtps_pd(_mm256_extractf128_ps(f.v, 1))}; }
  Doubles v_ = Doubles::all(0);
};

inline void store_rough(Doubles a, float* p) { _mm_storeu_ps(p, _mm256_cvtpd_ps(a.v)); }
inline Doubles load_rough(const float* p) { return {_mm256_cvtps_pd(_mm_loadu_ps(p))}; }

}  // namespace
