#include "thermal/thermography/harmonic_fit.hpp"

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace arenite::thermography {

void legendre(double x, std::size_t count, double* value, double* slope) {
  for (std::size_t j = 0; j < count; ++j) {
    const auto n = static_cast<double>(j);
    value[j] = j == 0 ? 1 : j == 1 ? x : ((2 * n - 1) * x * value[j - 1] - (n - 1) * value[j - 2]) / n;
    if (slope) slope[j] = j == 0 ? 0 : j == 1 ? 1 : slope[j - 2] + (2 * n - 1) * value[j - 1];
  }
}

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Index index(std::size_t i) { return static_cast<Index>(i); }

/// Swings at the frequencies beside, by turning that of the load's by the spacing, again and again.
void swings_beside(const HarmonicFit& fit, double t, VectorXd& phi) {
  const std::size_t own = fit.harmonic(1);
  const std::complex<double> load(phi[index(own)], phi[index(own + 1)]), turn = std::polar(1.0, 2 * std::numbers::pi * fit.spacing * t);
  std::complex<double> power = 1;
  for (int far = 1, left = static_cast<int>(fit.beside.size()); left > 0; ++far) {
    power *= turn;
    for (std::size_t k = 0; k < fit.beside.size(); ++k) {
      if (std::abs(fit.beside[k]) != far) continue;
      const std::complex<double> swing = load * (fit.beside[k] > 0 ? power : std::conj(power));
      phi[index(fit.side(k))] = swing.real();
      phi[index(fit.side(k) + 1)] = swing.imag();
      --left;
    }
  }
}

/// The functions that are fitted, at time t.
void functions_at(const HarmonicFit& fit, double t, bool with_beat, VectorXd& phi) {
  const double x = (t - fit.middle) / fit.half, angle = 2 * std::numbers::pi * fit.frequency * t;
  legendre(x, fit.drift, phi.data());
  for (std::size_t h = 1; h <= fit.harmonics; ++h) {
    phi[index(fit.harmonic(h))] = std::cos(static_cast<double>(h) * angle);
    phi[index(fit.harmonic(h) + 1)] = std::sin(static_cast<double>(h) * angle);
  }
  if (!fit.beside.empty()) swings_beside(fit, t, phi);
  if (!with_beat) return;
  const Index last = phi.size() - 2, cosine = index(fit.harmonic(1));
  phi[last] = x * phi[cosine];
  phi[last + 1] = x * phi[cosine + 1];
}

/// Rows: what the film is projected on in this segment, columns: 1 and the weights of the pass.
void projection(const HarmonicFit& fit, double centre, bool with_beat, MatrixXd& r) {
  r.setZero();
  const double x = (centre - fit.middle) / fit.half;
  VectorXd p(index(fit.drift));
  legendre(x, fit.drift, p.data());
  r.block(0, 0, index(fit.drift), 1) = p;
  const auto turn = [&](Index row, std::size_t h, double frequency, double size) {
    const double angle = 2 * std::numbers::pi * frequency * centre;
    const Index column = index(2 * h - 1);
    r(row, column) = size * std::cos(angle);
    r(row, column + 1) = -size * std::sin(angle);
    r(row + 1, column) = size * std::sin(angle);
    r(row + 1, column + 1) = size * std::cos(angle);
  };
  for (std::size_t h = 1; h <= fit.harmonics; ++h) turn(index(fit.harmonic(h)), h, static_cast<double>(h) * fit.frequency, 1);
  for (std::size_t k = 0; k < fit.beside.size(); ++k) turn(index(fit.side(k)), 1, fit.frequency + fit.beside[k] * fit.spacing, 1);
  if (with_beat) turn(r.rows() - 2, 1, fit.frequency, x);
}

}  // namespace

double HarmonicFit::inflation(std::size_t frames) const {
  const auto a = index(harmonic(1));
  return (covariance(a, a) + covariance(a + 1, a + 1)) * static_cast<double>(frames) / 4;
}

HarmonicFit harmonic_fit(const SegmentSums& s, double frequency, int drift_order, bool with_beat, double spacing,
                         std::vector<int> beside) {
  HarmonicFit fit;
  fit.frequency = frequency;
  fit.spacing = spacing;
  fit.beside = std::move(beside);
  fit.drift = static_cast<std::size_t>(drift_order) + 1;
  fit.harmonics = s.functions / 2;
  fit.middle = (s.time.front() + s.time.back()) / 2;
  fit.half = (s.time.back() - s.time.front()) / 2;
  const Index size = index(fit.drift + s.functions + 2 * fit.beside.size() + (with_beat ? 2 : 0)), weights = index(1 + s.functions), planes = index(s.planes());
  MatrixXd mixed = MatrixXd::Zero(size, size), tests = mixed, r(size, weights);
  MatrixXd projections = MatrixXd::Zero(size, index(s.segments()) * planes);
  fit.normal = mixed;
  VectorXd phi(size), g(weights);
  for (std::size_t k = 0; k < s.segments(); ++k) {
    MatrixXd crossed = MatrixXd::Zero(weights, size), squared = MatrixXd::Zero(weights, weights);
    for (std::size_t n = s.first[k]; n < s.first[k + 1]; ++n) {
      functions_at(fit, s.time[n], with_beat, phi);
      g[0] = 1;
      for (std::size_t m = 0; m < s.functions; ++m) g[index(m + 1)] = static_cast<double>(s.weights[n * s.functions + m]);
      crossed.noalias() += g * phi.transpose();
      squared.noalias() += g * g.transpose();
      fit.normal.noalias() += phi * phi.transpose();
    }
    projection(fit, s.centre[k], with_beat, r);
    mixed.noalias() += r * crossed;
    tests.noalias() += r * squared * r.transpose();
    projections.block(0, index(k) * planes, size, weights) = r;
    projections.col(index(k) * planes + planes - 1) = r * squared.col(0);
  }
  const Eigen::PartialPivLU<MatrixXd> inverse(mixed);
  fit.coefficient = inverse.solve(projections).transpose();
  fit.covariance = inverse.solve(inverse.solve(tests).transpose());
  return fit;
}

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
