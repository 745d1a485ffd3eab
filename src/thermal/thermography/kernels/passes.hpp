// The passes of kernels.hpp for lanes of some width: included by the sources of this folder, which are compiled with flags of
// their own, and therefore without names that a linker could take from one of them for another.
#pragma once
#include <cstdint>
#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "thermal/thermography/kernels/kernels.hpp"

namespace arenite::thermography {
namespace {

/// n numbers computed side by side; a single one is what is left over at the end of a row of lanes.
template <class T, std::size_t n> struct Lanes {
  typedef T Numbers __attribute__((vector_size(n * sizeof(T))));
  typedef T Anywhere __attribute__((vector_size(n * sizeof(T)), aligned(alignof(T)), may_alias));  // as they lie in an array
  static constexpr std::size_t lanes = n;
  Numbers v;

  static Lanes load(const float* p) {
#if defined(__AVX512F__)  // read and widened by one instruction; GCC 12 makes five of what is said below
    if constexpr (sizeof(Numbers) == 64 && sizeof(T) == 8) return {_mm512_cvtps_pd(_mm256_loadu_ps(p))};
#elif defined(__AVX2__)
    if constexpr (sizeof(Numbers) == 32 && sizeof(T) == 8) return {_mm256_cvtps_pd(_mm_loadu_ps(p))};
#endif
    return {__builtin_convertvector(*reinterpret_cast<const typename Lanes<float, n>::Anywhere*>(p), Numbers)};
  }
  static Lanes load(const std::uint16_t* p) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Numbers) == 64) return {_mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))))};
#elif defined(__AVX2__)
    if constexpr (sizeof(Numbers) == 32) return {_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))))};
#endif
    const auto& level = *reinterpret_cast<const typename Lanes<std::uint16_t, n>::Anywhere*>(p);
    return {__builtin_convertvector(__builtin_convertvector(level, typename Lanes<std::int32_t, n>::Numbers), Numbers)};
  }
  static Lanes all(T c) { return {c - Numbers{}}; }  // c - 0 is c, signed zeros too
  void store(T* p) const { *reinterpret_cast<Anywhere*>(p) = v; }
  friend Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
  /// Rounded once where the source is compiled so (cmake/kernels.cmake).
  friend Lanes fma(Lanes a, Lanes b, Lanes c) { return {a.v * b.v + c.v}; }
};

/// Frames whose share goes into sums that stay in registers; as many streams as a machine fetches ahead.
constexpr std::size_t group = 16;
/// Pixels whose sums stay in the second cache from group to group, in long runs of every frame.
constexpr std::size_t tile = 8192;

/// `n` neighbouring vectors at once, so that a weight is fetched once for all; `sums` are those of the first.
template <class V, int n, int functions, class T>
inline void add_group(const WeighedFrames<T>& f, std::size_t first, std::size_t count, float* sums, std::size_t p) {
  V sum[functions + 2][n], reference[n];
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < functions + 2; ++k) sum[k][i] = V::load(sums + static_cast<std::size_t>(k) * chunk + static_cast<std::size_t>(i) * V::lanes);
    reference[i] = V::load(f.reference + p + static_cast<std::size_t>(i) * V::lanes);
  }
  const T* value = f.frames + first * f.pixels + p;
  const float* weight = f.weights + first * functions;
  const std::size_t ahead = first + count + group <= f.count ? group * f.pixels : 0;
#pragma GCC unroll 4
  for (std::size_t j = 0; j < count; ++j, value += f.pixels, weight += functions) {
    __builtin_prefetch(value + ahead, 0, 2);
    V d[n];
    for (int i = 0; i < n; ++i) {
      d[i] = V::load(value + static_cast<std::size_t>(i) * V::lanes) - reference[i];
      sum[0][i] = sum[0][i] + d[i];
      sum[functions + 1][i] = fma(d[i], d[i], sum[functions + 1][i]);
    }
    for (int k = 0; k < functions; ++k) {
      const V w = V::all(weight[k]);
      for (int i = 0; i < n; ++i) sum[k + 1][i] = fma(w, d[i], sum[k + 1][i]);
    }
  }
  for (int k = 0; k < functions + 2; ++k)
    for (int i = 0; i < n; ++i) sum[k][i].store(sums + static_cast<std::size_t>(k) * chunk + static_cast<std::size_t>(i) * V::lanes);
}

template <class Floats, int functions, class T>
void add_frames(const WeighedFrames<T>& f, float* sums, std::size_t stride, std::size_t begin, std::size_t end) {
  constexpr std::size_t step = 2 * Floats::lanes;
  for (std::size_t from = begin; from < end; from += tile) {
    const std::size_t to = from + tile < end ? from + tile : end;
    for (std::size_t first = 0; first < f.count; first += group) {
      const std::size_t count = first + group < f.count ? group : f.count - first;
      const auto of = [&](std::size_t p) { return sums + p / chunk * stride + p % chunk; };
      std::size_t p = from;
      for (; p + step <= to; p += step) add_group<Floats, 2, functions>(f, first, count, of(p), p);
      for (; p < to; ++p) add_group<Lanes<float, 1>, 1, functions>(f, first, count, of(p), p);
    }
  }
}

template <class Floats, class T> void add(const WeighedFrames<T>& f, float* sums, std::size_t stride, std::size_t begin, std::size_t end) {
  if (f.functions == 2) add_frames<Floats, 2>(f, sums, stride, begin, end);
  else if (f.functions == 4) add_frames<Floats, 4>(f, sums, stride, begin, end);
  else if (f.functions == 6) add_frames<Floats, 6>(f, sums, stride, begin, end);
  else add_frames<Floats, 8>(f, sums, stride, begin, end);
}

template <class V, int rows> inline void combine_at(const SegmentView& s, std::size_t p, const double* coefficient, double* out, std::size_t apart) {
  V sum[rows];
  for (int m = 0; m < rows; ++m) sum[m] = V::all(0);
  const std::size_t count = s.segments * s.planes;
  const float* plane = s.sums + s.at(p, 0, 0);
  for (std::size_t q = 0; q < count; ++q, plane += chunk) {
    if constexpr (V::lanes > 1) __builtin_prefetch(plane + count * chunk);
    const V d = V::load(plane);
    for (int m = 0; m < rows; ++m) sum[m] = fma(V::all(coefficient[static_cast<std::size_t>(m) * count + q]), d, sum[m]);
  }
  for (int m = 0; m < rows; ++m) sum[m].store(out + static_cast<std::size_t>(m) * apart);
}

template <class Doubles, int rows>
void combine_rows(const SegmentView& s, const double* coefficient, double* out, std::size_t apart, std::size_t begin, std::size_t end) {
  std::size_t p = begin;
  for (; p + Doubles::lanes <= end; p += Doubles::lanes) combine_at<Doubles, rows>(s, p, coefficient, out + (p - begin), apart);
  for (; p < end; ++p) combine_at<Lanes<double, 1>, rows>(s, p, coefficient, out + (p - begin), apart);
}

template <class Doubles>
void combine(const SegmentView& s, const double* coefficient, std::size_t rows, double* out, std::size_t apart, std::size_t begin, std::size_t end) {
  const std::size_t count = s.segments * s.planes;
  std::size_t m = 0;
  for (; m + 8 <= rows; m += 8) combine_rows<Doubles, 8>(s, coefficient + m * count, out + m * apart, apart, begin, end);
  // What is left goes in one reading of the sums, too.
  using Combine = void (*)(const SegmentView&, const double*, double*, std::size_t, std::size_t, std::size_t);
  constexpr Combine rest[] = {combine_rows<Doubles, 1>, combine_rows<Doubles, 2>, combine_rows<Doubles, 3>, combine_rows<Doubles, 4>,
                              combine_rows<Doubles, 5>, combine_rows<Doubles, 6>, combine_rows<Doubles, 7>};
  if (m < rows) rest[rows - m - 1](s, coefficient + m * count, out + m * apart, apart, begin, end);
}

template <class V> inline void power_at(const SegmentView& s, std::size_t p, const double* frames, double* out) {
  V sum = V::all(0);
  const float* plane = s.sums + s.at(p, 0, 0);
  for (std::size_t q = 0; q < s.segments; ++q, plane += s.planes * chunk) {
    const V level = V::load(plane), squares = V::load(plane + (s.planes - 2) * chunk), step = V::load(plane + (s.planes - 1) * chunk);
    sum = fma(fma(V::all(frames[q]), step, level + level), step, sum + squares);
  }
  sum.store(out);
}

template <class Doubles> void power(const SegmentView& s, const double* frames, double* out, std::size_t begin, std::size_t end) {
  std::size_t p = begin;
  for (; p + Doubles::lanes <= end; p += Doubles::lanes) power_at<Doubles>(s, p, frames, out + (p - begin));
  for (; p < end; ++p) power_at<Lanes<double, 1>>(s, p, frames, out + (p - begin));
}

/// The passes for `floats` single or half as many double numbers at once.
template <std::size_t floats> constexpr Kernels kernels_of(const char* name) {
  using Floats = Lanes<float, floats>;
  using Doubles = Lanes<double, floats / 2>;
  return {name, add<Floats, std::uint16_t>, add<Floats, float>, combine<Doubles>, power<Doubles>};
}

}  // namespace
}  // namespace arenite::thermography
