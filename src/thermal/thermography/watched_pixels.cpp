#include "thermal/thermography/watched_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "core/median.hpp"
#include "thermal/thermography/segment_sums.hpp"
#include "thermal/thermography/harmonic_fit.hpp"

namespace arenite::thermography {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

/// Polynomials that slow changes follow, orthonormal over the frames: order x frames.
MatrixXd slow_changes(const std::vector<double>& time) {
  constexpr Index order = 4;
  MatrixXd slow(static_cast<Index>(time.size()), order);
  for (Index n = 0; n < slow.rows(); ++n) {
    double row[order];
    legendre(2 * (time[static_cast<std::size_t>(n)] - time.front()) / (time.back() - time.front()) - 1, order, row);
    for (Index k = 0; k < order; ++k) slow(n, k) = row[k];
  }
  const Eigen::HouseholderQR<MatrixXd> qr(slow);
  return (qr.householderQ() * MatrixXd::Identity(slow.rows(), order)).transpose();
}

/// Sums over pixels at every frequency of a transform with frames in evenly spaced slots.
struct Spectrum {
  double step = 0;  ///< Hz
  std::vector<double> power;
  std::vector<Complex> square;
};

Spectrum spectrum(const MatrixXf& value, const std::vector<double>& time) {
  const double rate = 2 * nyquist_frequency(time);
  const auto slot = [&](std::size_t n) { return static_cast<std::size_t>(std::lround((time[n] - time.front()) * rate)); };
  const std::size_t most = 64 * time.size();  // a film with far longer gaps than that has no spectrum
  std::size_t size = 2;
  while (size < 2 * (slot(time.size() - 1) + 1) && size <= most) size *= 2;
  if (size > most) return {};
  Spectrum all{rate / static_cast<double>(size), std::vector<double>(size / 2), std::vector<Complex>(size / 2)};
  Eigen::FFT<double> transform;
  std::vector<Complex> in(size), out(size);
  for (Index i = 0; i < value.rows(); i += 2) {  // two pixels at once, as real and imaginary part
    std::fill(in.begin(), in.end(), Complex{});
    const bool pair = i + 1 < value.rows();
    for (std::size_t n = 0; n < time.size(); ++n)
      in[std::min(slot(n), size - 1)] += Complex(static_cast<double>(value(i, static_cast<Index>(n))), pair ? static_cast<double>(value(i + 1, static_cast<Index>(n))) : 0);
    transform.fwd(out, in);
    for (std::size_t k = 1; k < size / 2; ++k) {
      const Complex a = 0.5 * (out[k] + std::conj(out[size - k])), b = Complex(0, -0.5) * (out[k] - std::conj(out[size - k]));
      all.power[k] += std::norm(a) + std::norm(b);
      all.square[k] += a * a + b * b;
    }
  }
  return all;
}

/// Median of the powers within so many bins of bin k, but not right beside it.
double power_around(const std::vector<double>& power, std::size_t k, std::size_t first, std::size_t end) {
  constexpr std::size_t near = 8, far = 72;
  std::vector<double> some;
  for (std::size_t j = std::max(first, k > far ? k - far : 0); j < std::min(end, k + far + 1); ++j)
    if (j + near < k || j > k + near) some.push_back(power[j]);
  return some.empty() ? 0 : median(std::move(some));
}

}  // namespace

WatchedPixels::WatchedPixels(const SegmentSums& s) : time_(s.time) {
  const auto frames = static_cast<Index>(s.time.size()), count = static_cast<Index>(s.watched.size());
  value_ = Eigen::Map<const MatrixXf>(s.seen.data(), count, frames);
  const MatrixXf slow = slow_changes(time_).cast<float>();
  value_ -= ((value_ * slow.transpose()).eval() * slow).eval();
  const Eigen::VectorXf spread = value_.rowwise().norm();
  Index used = 0;
  for (Index i = 0; i < count; ++i)
    if (spread[i] > 0 && std::isfinite(spread[i])) {
      if (used < i) value_.row(used) = value_.row(i);
      value_.row(used++) /= spread[i];
    }
  value_.conservativeResize(used, frames);
  for (Index n = 0; n < frames; ++n) {
    const double share = (time_[static_cast<std::size_t>(n)] - time_.front()) / (time_.back() - time_.front());
    value_.col(n) *= static_cast<float>(0.5 - 0.5 * std::cos(2 * std::numbers::pi * share));
  }
}

Eigen::MatrixXcf WatchedPixels::swings(const std::vector<double>& frequencies) const {
  const auto count = static_cast<Index>(frequencies.size());
  MatrixXf turn(value_.cols(), 2 * count);
  for (Index n = 0; n < turn.rows(); ++n)
    for (Index k = 0; k < count; ++k) {
      const double cycles = frequencies[static_cast<std::size_t>(k)] * time_[static_cast<std::size_t>(n)];
      const auto angle = static_cast<float>(2 * std::numbers::pi * (cycles - std::floor(cycles)));
      turn(n, k) = std::cos(angle), turn(n, count + k) = std::sin(angle);
    }
  const MatrixXf sums = value_ * turn;
  Eigen::MatrixXcf z(value_.rows(), count);
  z.real() = sums.leftCols(count), z.imag() = sums.rightCols(count);
  return z;
}

bool WatchedPixels::have_line(double frequency) const {
  constexpr double level = 0.01;
  const double length = film_length(time_);
  std::vector<double> at{frequency};
  for (const int bins : {-9, -7, -5, -3, 3, 5, 7, 9})
    if (const double f = frequency + bins / length; f * length >= 2 && f <= nyquist_frequency(time_)) at.push_back(f);
  if (value_.rows() == 0 || at.size() < 3) return true;  // nothing to compare with
  const Eigen::VectorXd in_one_phase = swings(at).array().square().colwise().sum().abs().cast<double>();
  const double beside = static_cast<double>(at.size() - 1);
  return std::pow(1 + in_one_phase[0] / in_one_phase.tail(in_one_phase.size() - 1).sum(), -beside) < level;
}

std::optional<double> WatchedPixels::stronger_part(double frequency) const {
  const double length = film_length(time_);
  std::vector<double> at{frequency};
  for (const int part : {2, 3, 4})
    if (const double f = frequency / part; f * length >= 4) at.insert(at.end(), {f, f - 2.5 / length, f + 2.5 / length});
  if (value_.rows() == 0 || at.size() < 2) return std::nullopt;
  const Eigen::VectorXd power = swings(at).cwiseAbs2().colwise().sum().cast<double>();
  std::optional<double> best;
  double most = 4 * power[0];
  for (Index k = 1; k < power.size(); k += 3)
    if (power[k] > most && power[k] > 2 * (power[k + 1] + power[k + 2])) most = power[k], best = at[static_cast<std::size_t>(k)];
  return best;
}

std::optional<double> WatchedPixels::strongest_line() const {
  constexpr double one_phase = 0.5;
  const Spectrum all = spectrum(value_, time_);
  if (value_.rows() == 0 || all.power.empty()) return std::nullopt;
  const double length = film_length(time_);
  const auto first = static_cast<std::size_t>(std::ceil(2 / length / all.step)), end = all.power.size() - static_cast<std::size_t>(1 / length / all.step);
  if (first + 2 >= end) return std::nullopt;
  // What all pixels share has powers that are exponential: so far above their median is the largest of all once in a hundred films.
  const double clear = std::log(100 * static_cast<double>(end - first)) / std::numbers::ln2;
  std::size_t best = 0;
  for (std::size_t k = first; k + 1 < end; ++k)
    if ((best == 0 || all.power[k] > all.power[best]) && std::abs(all.square[k]) > one_phase * all.power[k] &&
        all.power[k] > clear * power_around(all.power, k, first, end))
      best = k;
  if (best == 0) return std::nullopt;
  const double before = std::log(all.power[best - 1]), at = std::log(all.power[best]), after = std::log(all.power[best + 1]), curve = before - 2 * at + after;
  const double shift = curve < 0 ? std::clamp(0.5 * (before - after) / curve, -0.5, 0.5) : 0;
  return (static_cast<double>(best) + shift) * all.step;
}

}  // namespace arenite::thermography
