#include "thermal/thermography/harmonic_fit.hpp"

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

void legendre(double x, std::size_t count, double* value, double* slope) {
  for (std::size_t j = 0; j < count; ++j) {
    const auto n = static_cast<double>(j);
    value[j] = j == 0 ? 1 : j == 1 ? x : ((2 * n - 1) * x * value[j - 1] - (n - 1) * value[j - 2]) / n;
    if (slope) slope[j] = j == 0 ? 0 : j == 1 ? 1 : slope[j - 2] + (2 * n - 1) * value[j - 1];
  }
}

namespace {

using statistics::Matrix;

/// Cos and sin of the frequencies beside, by turning those of the load's by the spacing, again and again.
void sinusoids_beside(const HarmonicFit& fit, double t, double* phi) {
  const std::size_t own = fit.harmonic(1);
  const std::complex<double> load(phi[own], phi[own + 1]),
      turn = std::polar(1.0, 2 * std::numbers::pi * fit.spacing * t);
  for (std::size_t k = 0; k < fit.beside.size(); ++k) {
    std::complex<double> power = 1;
    for (int far = std::abs(fit.beside[k]); far > 0; --far) power *= turn;
    const std::complex<double> phasor = load * (fit.beside[k] > 0 ? power : std::conj(power));
    phi[fit.side(k)] = phasor.real();
    phi[fit.side(k) + 1] = phasor.imag();
  }
}

/// The functions that are fitted, at frame n.
void functions_at(const HarmonicFit& fit, const SegmentSums& s, std::size_t n, double* phi) {
  const double t = s.time[n];
  const double x = (t - fit.middle) / fit.half, angle = 2 * std::numbers::pi * fit.frequency * t;
  legendre(x, fit.drift, phi);
  for (std::size_t k = 0; k < fit.levels; ++k) phi[fit.drift + k] = s.levels[k][n];
  for (std::size_t h = 1; h <= fit.harmonics; ++h) {
    phi[fit.harmonic(h)] = std::cos(static_cast<double>(h) * angle);
    phi[fit.harmonic(h) + 1] = std::sin(static_cast<double>(h) * angle);
  }
  if (!fit.beside.empty()) sinusoids_beside(fit, t, phi);
  if (fit.beat)
    for (const std::size_t k : {0, 1}) phi[fit.size() - 2 + k] = x * phi[fit.harmonic(1) + k];
}

/// Rows: what the film is projected on in this segment, columns: 1 and the weights of the pass.
Matrix projection(const HarmonicFit& fit, const SegmentSums& s, std::size_t segment, std::size_t weights) {
  Matrix r(fit.size(), weights);
  const double centre = s.centre[segment];
  const double x = (centre - fit.middle) / fit.half;
  legendre(x, fit.drift, r.column(0));
  for (std::size_t k = 0; k < fit.levels; ++k)
    for (std::size_t n = s.first[segment]; n < s.first[segment + 1]; ++n)
      r(fit.drift + k, 0) += s.levels[k][n] / s.frames_of(segment);
  const auto turn = [&](std::size_t row, std::size_t h, double frequency, double amount) {
    const double angle = 2 * std::numbers::pi * frequency * centre;
    const std::size_t column = 2 * h - 1;
    r(row, column) = amount * std::cos(angle);
    r(row, column + 1) = -amount * std::sin(angle);
    r(row + 1, column) = amount * std::sin(angle);
    r(row + 1, column + 1) = amount * std::cos(angle);
  };
  for (std::size_t h = 1; h <= fit.harmonics; ++h) turn(fit.harmonic(h), h, static_cast<double>(h) * fit.frequency, 1);
  for (std::size_t k = 0; k < fit.beside.size(); ++k)
    turn(fit.side(k), 1, fit.frequency + fit.beside[k] * fit.spacing, 1);
  if (fit.beat) turn(fit.size() - 2, 1, fit.frequency, x);
  return r;
}

}  // namespace

statistics::Matrix pass_weights(const SegmentSums& s, std::size_t k) {
  Matrix g(1 + s.functions, s.first[k + 1] - s.first[k]);
  for (std::size_t n = 0; n < g.columns(); ++n) {
    g(0, n) = 1;
    for (std::size_t m = 0; m < s.functions; ++m)
      g(m + 1, n) = static_cast<double>(s.weights[(s.first[k] + n) * s.functions + m]);
  }
  return g;
}

HarmonicFit harmonic_fit(const SegmentSums& s, double frequency, int drift_order, bool with_beat, double spacing,
                         std::vector<int> beside) {
  HarmonicFit fit{frequency,
                  static_cast<std::size_t>(drift_order) + 1,
                  s.levels.size(),
                  s.functions / 2,
                  (s.time.front() + s.time.back()) / 2,
                  (s.time.back() - s.time.front()) / 2,
                  spacing,
                  std::move(beside),
                  with_beat};
  const std::size_t size = fit.size(), planes = s.planes();
  Matrix mixed(size, size), tests(size, size), projections(size, s.segments() * planes);
  fit.normal = Matrix(size, size);
  for (std::size_t k = 0; k < s.segments(); ++k) {
    const Matrix g = pass_weights(s, k);
    Matrix phi(size, g.columns());
    for (std::size_t n = 0; n < g.columns(); ++n) functions_at(fit, s, s.first[k] + n, phi.column(n));
    if (fit.beside.empty()) fit.normal += times_transposed(phi, phi);
    const Matrix squared = times_transposed(g, g), r = projection(fit, s, k, g.rows()), turned = r * squared;
    mixed += r * times_transposed(g, phi);
    tests += times_transposed(turned, r);
    std::copy_n(r.column(0), r.size(), projections.column(k * planes));
    std::copy_n(turned.column(0), size, projections.column(k * planes + planes - 1));
  }
  fit.coefficient = transposed(solve(mixed, projections));
  fit.covariance = solve(mixed, transposed(solve(mixed, tests)));
  return fit;
}

void fit_pixels(const SegmentSums& sums, const HarmonicFit& fit, std::size_t from, std::size_t rows, std::size_t begin,
                std::size_t count, PixelFit& out) {
  out.value.resize(rows * PixelFit::run);
  kernels().combine(sums.view(), fit.coefficient.column(from), rows, out.value.data(), PixelFit::run, begin,
                    begin + count);
}

void fit_pixels_with_variance(const SegmentSums& sums, const HarmonicFit& fit, std::size_t begin, std::size_t count,
                              PixelFit& out) {
  const std::size_t size = fit.size();
  fit_pixels(sums, fit, 0, size, begin, count, out);
  std::vector<double> frames(sums.segments());
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k] = sums.frames_of(k);
  out.variance.resize(PixelFit::run);
  kernels().residual(sums.view(), frames.data(), fit.normal.column(0), size, out.value.data(), PixelFit::run,
                     out.variance.data(), begin, begin + count);
  const double freedom = static_cast<double>(sums.time.size() - size);
  for (std::size_t i = 0; i < count; ++i) out.variance[i] = out.variance[i] < 0 ? 0 : out.variance[i] / freedom;
}

}  // namespace arenite::thermography
