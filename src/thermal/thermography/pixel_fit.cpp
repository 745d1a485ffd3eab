#include "thermal/thermography/pixel_fit.hpp"

namespace arenite::thermography {

void fit_pixels(const SegmentSums& sums, const HarmonicFit& fit, std::size_t from, std::size_t rows, std::size_t begin, std::size_t count,
                PixelFit& out) {
  out.begin = begin;
  out.count = count;
  out.value.resize(rows * PixelFit::run);
  const auto stride = static_cast<std::size_t>(fit.coefficient.rows());
  kernels().combine(sums.view(), fit.coefficient.data() + from * stride, rows, out.value.data(), PixelFit::run, begin, begin + count);
}

void fit_pixels_with_variance(const SegmentSums& sums, const HarmonicFit& fit, std::size_t begin, std::size_t count, PixelFit& out) {
  const std::size_t size = fit.size();
  fit_pixels(sums, fit, 0, size, begin, count, out);
  std::vector<double> frames(sums.segments());
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k] = sums.frames_of(k);
  out.variance.resize(PixelFit::run);
  kernels().power(sums.view(), frames.data(), out.variance.data(), begin, begin + count);
  const double freedom = static_cast<double>(sums.time.size() - size);
  for (std::size_t m = 0; m < size; ++m)
    for (std::size_t n = 0; n <= m; ++n) {
      const double weight = (n == m ? 1 : 2) * fit.normal(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(n));
      const double *a = out.value.data() + m * PixelFit::run, *b = out.value.data() + n * PixelFit::run;
      for (std::size_t i = 0; i < count; ++i) out.variance[i] -= weight * a[i] * b[i];
    }
  for (std::size_t i = 0; i < count; ++i) out.variance[i] = out.variance[i] < 0 ? 0 : out.variance[i] / freedom;
}

}  // namespace arenite::thermography
