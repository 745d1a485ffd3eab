// The passes of kernels.hpp for lanes of some width: included by the sources of this folder, which are compiled with
// flags of their own, and therefore without names that a linker could take from one of them for another.
#pragma once
#include <array>
#include <cstdint>
#include <utility>

#include "core/lanes.hpp"
#include "thermal/thermography/kernels/kernels.hpp"

namespace arenite::thermography {
namespace {

/// `n` neighbouring vectors at once, so that a weight is fetched once for all; `sums` are those of the first.
template <class V, int n, int functions, class T>
inline void add_pixels(const WeighedFrames<T>& f, float* sums, std::size_t p) {
  V sum[functions + 2][n], reference[n];
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < functions + 2; ++k)
      sum[k][i] = V::load(sums + static_cast<std::size_t>(k) * chunk + static_cast<std::size_t>(i) * V::lanes);
    reference[i] = V::load(f.reference + p + static_cast<std::size_t>(i) * V::lanes);
  }
  const T* value = f.frames + p;
  const float* weight = f.weights;
  std::size_t j = 0;
  do {  // of at least one frame: sums that the loop might leave alone would go to memory before it
    __builtin_prefetch(value + f.ahead, 0, 2);
    V d[n];
    for (int i = 0; i < n; ++i) {
      d[i] = V::load(value + static_cast<std::size_t>(i) * V::lanes) - reference[i];
      sum[0][i] = sum[0][i] + d[i];
      sum[functions + 1][i] = fma(d[i], d[i], sum[functions + 1][i]);
    }
    for (int k = 0; k < functions; ++k) {
      const V w = V(weight[k]);
      for (int i = 0; i < n; ++i) sum[k + 1][i] = fma(w, d[i], sum[k + 1][i]);
    }
    value += f.pixels, weight += functions;
  } while (++j < f.count);
  for (int k = 0; k < functions + 2; ++k)
    for (int i = 0; i < n; ++i)
      sum[k][i].store(sums + static_cast<std::size_t>(k) * chunk + static_cast<std::size_t>(i) * V::lanes);
}

template <class Floats, int functions, class T>
void add_frames(const WeighedFrames<T>& f, float* sums, std::size_t stride, std::size_t begin, std::size_t end) {
  constexpr std::size_t step = 2 * Floats::lanes;
  const auto of = [&](std::size_t p) { return sums + p / chunk * stride + p % chunk; };
  std::size_t p = begin;
  for (; p + step <= end; p += step) add_pixels<Floats, 2, functions>(f, of(p), p);
  for (; p < end; ++p) add_pixels<Lanes<float, 1>, 1, functions>(f, of(p), p);
}

template <class Floats, class T>
void add(const WeighedFrames<T>& f, float* sums, std::size_t stride, std::size_t begin, std::size_t end) {
  if (f.functions == 2) add_frames<Floats, 2>(f, sums, stride, begin, end);
  else if (f.functions == 4) add_frames<Floats, 4>(f, sums, stride, begin, end);
  else if (f.functions == 6) add_frames<Floats, 6>(f, sums, stride, begin, end);
  else add_frames<Floats, 8>(f, sums, stride, begin, end);
}

template <class V, int rows>
inline void combine_at(const SegmentView& s, std::size_t p, const double* coefficient, double* out, std::size_t apart) {
  V sum[rows];
  for (int m = 0; m < rows; ++m) sum[m] = V(0);
  const std::size_t count = s.segments * s.planes;
  const float* plane = s.sums + s.at(p, 0, 0);
  for (std::size_t q = 0; q < count; ++q, plane += chunk) {
    if constexpr (V::lanes > 1) __builtin_prefetch(plane + count * chunk);
    const V d = V::load(plane);
    for (int m = 0; m < rows; ++m) sum[m] = fma(V(coefficient[static_cast<std::size_t>(m) * count + q]), d, sum[m]);
  }
  for (int m = 0; m < rows; ++m) sum[m].store(out + static_cast<std::size_t>(m) * apart);
}

/// Calls at(lanes' type, number) for pixels 0 .. count - 1: lanes of them, then what is left over one by one.
template <class Doubles, class At> inline void each_pixel(std::size_t count, const At& at) {
  std::size_t i = 0;
  for (; i + Doubles::lanes <= count; i += Doubles::lanes) at(Doubles{}, i);
  for (; i < count; ++i) at(Lanes<double, 1>{}, i);
}

template <class Doubles, int rows>
void combine_rows(const SegmentView& s, const double* coefficient, double* out, std::size_t apart, std::size_t begin,
                  std::size_t end) {
  each_pixel<Doubles>(
      end - begin, [&]<class V>(V, std::size_t i) { combine_at<V, rows>(s, begin + i, coefficient, out + i, apart); });
}

/// As many rows in one reading of the sums as registers hold.
template <class Doubles>
void combine(const SegmentView& s, const double* coefficient, std::size_t rows, double* out, std::size_t apart,
             std::size_t begin, std::size_t end) {
  constexpr std::size_t most = 13;
  const std::size_t count = s.segments * s.planes, readings = (rows + most - 1) / most;
  const auto table = []<int... few>(std::integer_sequence<int, few...>) {
    return std::array{combine_rows<Doubles, few + 1>...};
  }
  (std::make_integer_sequence<int, most>());
  for (std::size_t r = 0; r < readings; ++r) {
    const std::size_t first = rows * r / readings, some = rows * (r + 1) / readings - first;
    table[some - 1](s, coefficient + first * count, out + first * apart, apart, begin, end);
  }
}

template <class V>
inline void residual_at(const SegmentView& s, std::size_t p, const double* frames, const double* normal,
                        std::size_t rows, const double* fitted, std::size_t apart, double* out) {
  V sum = V(0);
  const float* plane = s.sums + s.at(p, 0, 0);
  for (std::size_t q = 0; q < s.segments; ++q, plane += s.planes * chunk) {
    const V level = V::load(plane), squares = V::load(plane + (s.planes - 2) * chunk),
            step = V::load(plane + (s.planes - 1) * chunk);
    sum = fma(fma(V(frames[q]), step, level + level), step, sum + squares);
  }
  for (std::size_t m = 0; m < rows; ++m, normal += rows) {
    V mixed = V(0);
    for (std::size_t n = 0; n < m; ++n) mixed = fma(V(normal[n]), V::load(fitted + n * apart), mixed);
    const V own = V::load(fitted + m * apart);
    sum = fma(V(0) - own, fma(V(normal[m]), own, mixed + mixed), sum);
  }
  sum.store(out);
}

template <class Doubles>
void residual(const SegmentView& s, const double* frames, const double* normal, std::size_t rows, const double* fitted,
              std::size_t apart, double* out, std::size_t begin, std::size_t end) {
  each_pixel<Doubles>(end - begin, [&]<class V>(V, std::size_t i) {
    residual_at<V>(s, begin + i, frames, normal, rows, fitted + i, apart, out + i);
  });
}

template <class V, int n>
inline void steps_at(const double* frame, std::size_t pixels, const double* weight, std::size_t reach, double* step) {
  V sum[n];
  for (int i = 0; i < n; ++i) sum[i] = V(0);
  const double *after = frame, *before = frame - pixels;
  for (std::size_t k = 0; k < reach; ++k, after += pixels, before -= pixels)
    for (int i = 0; i < n; ++i)
      sum[i] = fma(V(weight[k]), V::load(after + i * V::lanes) - V::load(before + i * V::lanes), sum[i]);
  for (int i = 0; i < n; ++i) sum[i].store(step + i * V::lanes);
}

template <class Doubles>
void steps(const double* frame, std::size_t pixels, const double* weight, std::size_t reach, double* step) {
  constexpr std::size_t some = 4 * Doubles::lanes;  // whose sums stay in registers
  std::size_t i = 0;
  for (; i + some <= pixels; i += some) steps_at<Doubles, 4>(frame + i, pixels, weight, reach, step + i);
  for (; i < pixels; ++i) steps_at<Lanes<double, 1>, 1>(frame + i, pixels, weight, reach, step + i);
}

/// The passes for `floats` single or half as many double numbers at once.
template <int floats> constexpr Kernels kernels_of(const char* name) {
  using Floats = Lanes<float, floats>;
  using Doubles = Lanes<double, floats / 2>;
  return {name, add<Floats, std::uint16_t>, add<Floats, float>, combine<Doubles>, residual<Doubles>, steps<Doubles>};
}

}  // namespace
}  // namespace arenite::thermography
