#include "thermal/thermography/watched_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "core/median.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/refine_frequency.hpp"

namespace arenite::thermography {
namespace {

using Complex = std::complex<double>;
using statistics::FloatMatrix;

/// Polynomials that slow changes follow, and other changes of the level, orthonormal over the frames: frames x
/// functions.
FloatMatrix slow_changes(const SegmentSums& s) {
  constexpr std::size_t order = 4;
  const std::vector<double>& time = s.time;
  statistics::Matrix slow(time.size(), order + s.levels.size());
  for (std::size_t n = 0; n < slow.rows(); ++n) {
    double row[order];
    legendre(2 * (time[n] - time.front()) / (time.back() - time.front()) - 1, order, row);
    for (std::size_t k = 0; k < order; ++k) slow(n, k) = row[k];
    for (std::size_t k = 0; k < s.levels.size(); ++k) slow(n, order + k) = s.levels[k][n];
  }
  const statistics::Matrix q = statistics::orthonormal(slow).q;
  FloatMatrix result(slow.rows(), slow.columns());
  std::transform(q.column(0), q.column(slow.columns()), result.column(0),
                 [](double v) { return static_cast<float>(v); });
  return result;
}

/// Sums over pixels at every frequency of a transform with frames in evenly spaced slots.
struct Spectrum {
  double step = 0;  ///< Hz
  std::vector<double> power;
  std::vector<Complex> square;
};

Spectrum spectrum(const FloatMatrix& value, const std::vector<double>& time) {
  const double rate = 2 * nyquist_frequency(time);
  const auto slot = [&](std::size_t n) {
    return static_cast<std::size_t>(std::lround((time[n] - time.front()) * rate));
  };
  const std::size_t most = 64 * time.size();  // a film with far longer gaps than that has no spectrum
  std::size_t size = 2;
  while (size < 2 * (slot(time.size() - 1) + 1) && size <= most) size *= 2;
  if (size > most) return {};
  Spectrum all{rate / static_cast<double>(size), std::vector<double>(size / 2), std::vector<Complex>(size / 2)};
  Eigen::FFT<double> transform({}, Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> in;
  std::vector<Complex> out;
  for (std::size_t i = 0; i < value.rows(); ++i) {
    in.assign(size, 0.0);
    for (std::size_t n = 0; n < time.size(); ++n) in[std::min(slot(n), size - 1)] += static_cast<double>(value(i, n));
    transform.fwd(out, in);
    for (std::size_t k = 1; k < size / 2; ++k) all.power[k] += std::norm(out[k]), all.square[k] += out[k] * out[k];
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

WatchedPixels::WatchedPixels(const SegmentSums& s) : time_(s.time), value_(s.watched.size(), s.time.size()) {
  for (std::size_t n = 0; n < value_.columns(); ++n)
    for (std::size_t i = 0; i < value_.rows(); ++i) value_(i, n) = s.seen[i * value_.columns() + n];
  const FloatMatrix slow = slow_changes(s);
  value_ -= times_transposed(value_ * slow, slow);
  std::vector<float> squares(value_.rows());
  for (std::size_t n = 0; n < value_.columns(); ++n)
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] += value_(i, n) * value_(i, n);
  const auto changes = [](float sum) { return sum > 0 && std::isfinite(sum); };
  if (std::ranges::none_of(squares, changes)) value_ = {};
  for (std::size_t n = 0; n < value_.columns(); ++n) {
    const double share = (time_[n] - time_.front()) / (time_.back() - time_.front());
    const auto window = static_cast<float>(0.5 - 0.5 * std::cos(2 * std::numbers::pi * share));
    for (std::size_t i = 0; i < value_.rows(); ++i)
      value_(i, n) = changes(squares[i]) ? value_(i, n) / std::sqrt(squares[i]) * window : 0;
  }
}

std::vector<WatchedPixels::Line> WatchedPixels::lines_at(const std::vector<double>& frequencies) const {
  const std::size_t count = frequencies.size();
  FloatMatrix turn(value_.columns(), 2 * count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t n = 0; n < turn.rows(); ++n) {
      const double cycles = frequencies[k] * time_[n];
      const auto angle = static_cast<float>(2 * std::numbers::pi * (cycles - std::floor(cycles)));
      turn(n, k) = std::cos(angle), turn(n, count + k) = std::sin(angle);
    }
  const FloatMatrix sums = value_ * turn;
  std::vector<Line> lines;
  for (std::size_t k = 0; k < count; ++k) {
    Complex square = 0;
    double power = 0;
    for (std::size_t i = 0; i < sums.rows(); ++i) {
      const Complex z(static_cast<double>(sums(i, k)), static_cast<double>(sums(i, count + k)));
      power += std::norm(z), square += z * z;
    }
    lines.push_back({power, std::abs(square)});
  }
  return lines;
}

bool WatchedPixels::have_line(double frequency) const {
  constexpr double level = 0.01;
  const double length = film_length(time_);
  std::vector<double> at{frequency};
  for (const int bins : {-9, -7, -5, -3, 3, 5, 7, 9})
    if (const double f = frequency + bins / length; f * length >= 2 && f <= nyquist_frequency(time_)) at.push_back(f);
  if (value_.rows() == 0 || at.size() < 3) return true;  // nothing to compare with
  const std::vector<Line> all = lines_at(at);
  double around = 0;
  for (std::size_t k = 1; k < all.size(); ++k) around += all[k].in_one_phase;
  return std::pow(1 + all[0].in_one_phase / around, -static_cast<double>(at.size() - 1)) < level;
}

std::optional<double> WatchedPixels::stronger_part(double frequency) const {
  const double length = film_length(time_);
  std::vector<double> at{frequency};
  for (const int part : {2, 3, 4})
    if (const double f = frequency / part; f * length >= 4)
      at.insert(at.end(), {f, f - 2.5 / length, f + 2.5 / length});
  if (value_.rows() == 0 || at.size() < 2) return std::nullopt;
  const std::vector<Line> all = lines_at(at);
  std::optional<double> best;
  double most = 4 * all[0].power;
  for (std::size_t k = 1; k < all.size(); k += 3)
    if (all[k].power > most && all[k].power > 2 * (all[k + 1].power + all[k + 2].power))
      most = all[k].power, best = at[k];
  return best;
}

std::optional<double> WatchedPixels::strongest_line() const {
  constexpr double one_phase = 0.5;
  const Spectrum all = spectrum(value_, time_);
  if (value_.rows() == 0 || all.power.empty()) return std::nullopt;
  const double length = film_length(time_);
  const auto first = static_cast<std::size_t>(std::ceil(2 / length / all.step)),
             end = all.power.size() - static_cast<std::size_t>(1 / length / all.step);
  if (first + 2 >= end) return std::nullopt;
  // What all pixels share has powers that are exponential: so far above their median is the largest of all once in a
  // hundred films.
  const double clear = std::log(100 * static_cast<double>(end - first)) / std::numbers::ln2;
  std::size_t best = 0;
  for (std::size_t k = first; k + 1 < end; ++k)
    if ((best == 0 || all.power[k] > all.power[best]) && std::abs(all.square[k]) > one_phase * all.power[k] &&
        all.power[k] > clear * power_around(all.power, k, first, end))
      best = k;
  if (best == 0) return std::nullopt;
  const auto log_power = [&](std::size_t k) { return std::log(all.power[k]); };
  return (static_cast<double>(best) + peak_between(log_power(best - 1), log_power(best), log_power(best + 1))) *
         all.step;
}

}  // namespace arenite::thermography
