#include "thermal/thermography/segments_in_step.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace arenite::thermography {

namespace {

using Eigen::Index;

constexpr double turn = 2 * std::numbers::pi;

/// Numbers by which the sums of segment k give its swing by least squares on its mean and harmonics: rows cos, sin.
Eigen::MatrixXd own_fit(const SegmentSums& s, std::size_t k) {
  const auto size = static_cast<Index>(1 + s.functions);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd g(size);
  for (std::size_t n = s.first[k]; n < s.first[k + 1]; ++n) {
    g[0] = 1;
    for (std::size_t m = 0; m < s.functions; ++m) g[static_cast<Index>(m + 1)] = static_cast<double>(s.weights[n * s.functions + m]);
    normal.noalias() += g * g.transpose();
  }
  return Eigen::PartialPivLU<Eigen::MatrixXd>(normal).inverse().middleRows(1, 2);
}

/// Swing of one pixel in every segment, over its spread, so that a wild pixel does not speak for all.
bool swings_of(const SegmentSums& s, const std::vector<Eigen::MatrixXd>& fits, std::size_t p, Eigen::VectorXcd& swing) {
  const SegmentView view = s.view();
  const float* plane = view.sums + view.at(p, 0, 0);
  double spread = 0;
  for (std::size_t k = 0; k < s.segments(); ++k, plane += view.planes * chunk) {
    std::complex<double> z = 0;
    for (std::size_t m = 0; m <= s.functions; ++m) {
      const auto v = static_cast<double>(plane[m * chunk]);
      z += std::complex<double>(fits[k](0, static_cast<Index>(m)), fits[k](1, static_cast<Index>(m))) * v;
    }
    const auto sum = static_cast<double>(plane[0]);
    spread += static_cast<double>(plane[(s.functions + 1) * chunk]) - sum * sum / s.frames_of(k);
    swing[static_cast<Index>(k)] = z * s.frames_of(k);
  }
  if (!(spread > 0) || !std::isfinite(spread)) return false;
  swing /= std::sqrt(spread);
  return swing.allFinite();
}

Eigen::MatrixXcd products(const SegmentSums& s) {
  std::vector<Eigen::MatrixXd> fits;
  for (std::size_t k = 0; k < s.segments(); ++k) fits.push_back(own_fit(s, k));
  const auto size = static_cast<Index>(s.segments());
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(size, size);
  Eigen::VectorXcd swing(size);
  const std::size_t chunks = (s.pixels + chunk - 1) / chunk, every = std::max<std::size_t>(1, chunks / 64);
  for (std::size_t c = 0; c < chunks; c += every)
    for (std::size_t p = c * chunk; p < std::min((c + 1) * chunk, s.pixels); ++p)
      if (swings_of(s, fits, p, swing)) sum.noalias() += swing.conjugate() * swing.transpose();
  return sum;
}

}  // namespace

bool segments_show_swings(const SegmentSums& s) {
  return s.frequency * (s.time.back() - s.time.front()) >= 1.5 * static_cast<double>(s.segments());
}

double segments_in_step(const SegmentSums& s, double low, double high) {
  const double time = s.time.back() - s.time.front(), segment = time / static_cast<double>(s.segments());
  const double below = std::min(s.frequency - low, 0.4 / segment), above = std::min(high - s.frequency, 0.4 / segment), step = 1 / (8 * time);
  const Eigen::MatrixXcd product = products(s);
  Eigen::VectorXcd phase(product.rows());
  const auto power = [&](double frequency) {
    for (Index k = 0; k < phase.size(); ++k) phase[k] = std::polar(1.0, turn * frequency * s.centre[static_cast<std::size_t>(k)]);
    return phase.dot(product * phase).real();
  };
  int best = 0;
  double most = -1;
  for (int k = -static_cast<int>(below / step); k <= static_cast<int>(above / step); ++k)
    if (const double p = power(s.frequency + k * step); p > most) most = p, best = k;
  const double before = power(s.frequency + (best - 1) * step), after = power(s.frequency + (best + 1) * step);
  const double curve = before - 2 * most + after, shift = curve < 0 ? std::clamp(0.5 * (before - after) / curve, -0.5, 0.5) : 0;
  return s.frequency + (best + shift) * step;
}

}  // namespace arenite::thermography
