#include "thermal/thermography/load_signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/mapped.hpp"
#include "statistics/correlation.hpp"
#include "statistics/least_squares.hpp"

namespace arenite::thermography {
namespace {

constexpr double least_share = 0.5;

struct Fit {
  double left = 0;  ///< squares that the fit leaves
  double cosine = 0, sine = 0;
};

/// `time` is held against its middle, so that the columns are nearly orthogonal; phases are then of that moment.
Fit fit_at(double frequency, const std::vector<double>& time, const std::vector<double>& signal) {
  statistics::SmallNormal<4> normal;
  std::vector<std::array<double, 4>> rows;
  for (std::size_t n = 0; n < time.size(); ++n) {
    const double angle = 2 * std::numbers::pi * frequency * time[n];
    rows.push_back({1, time[n], std::cos(angle), std::sin(angle)});
    normal.add(rows.back(), signal[n], 1);
  }
  const auto x = normal.solution();
  double left = 0;
  for (std::size_t n = 0; n < time.size(); ++n)
    left += std::pow(std::inner_product(x.begin(), x.end(), rows[n].begin(), -signal[n]), 2);
  return {left, x[2], x[3]};
}

double left_by_line(const std::vector<double>& time, const std::vector<double>& signal) {
  const auto m = statistics::second_moments(time, signal);
  return m.yy - m.xy * m.xy / m.xx;
}

}  // namespace

std::optional<LoadSignal> fit_load_signal(const std::vector<double>& time, const std::vector<double>& signal,
                                          double given) {
  if (time.size() != signal.size() || time.size() < 8 || !(given > 0)) return std::nullopt;
  const auto n = static_cast<double>(time.size());
  const double middle = std::accumulate(time.begin(), time.end(), 0.0) / n, length = time.back() - time.front();
  const auto t = mapped(time, [&](double each) { return each - middle; });
  const double nyquist = 0.5 * (n - 1) / length, first = std::max(given / 2, 2 / length),
               last = std::min(2 * given, 0.95 * nyquist);
  double step = 1 / (8 * length), best = 0, least = left_by_line(t, signal);
  const double all = least;
  for (double f = first; f <= last; f += step)
    if (const double left = fit_at(f, t, signal).left; left < least) least = left, best = f;
  if (best == 0 || !(least < (1 - least_share) * all)) return std::nullopt;
  for (; step > 1e-9 * best; step /= 2)
    for (const double f : {best - step, best + step})
      if (const double left = fit_at(f, t, signal).left; left < least) least = left, best = f;
  const Fit fit = fit_at(best, t, signal);
  const double amplitude = std::hypot(fit.cosine, fit.sine), noise = std::sqrt(fit.left / (n - 4));
  const double phase = std::atan2(fit.sine, fit.cosine) + 2 * std::numbers::pi * best * middle;
  return LoadSignal{best, std::sqrt(6.0 / n) * noise / (std::numbers::pi * length * amplitude),
                    std::remainder(phase, 2 * std::numbers::pi)};
}

}  // namespace arenite::thermography
