#include "thermography/refine_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "thermography/pixel_fit.hpp"
#include "thermography/segments_in_step.hpp"

namespace arenite::thermography {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// What a Newton step adds up over pixels of weight w: with c, s of cos and sin, p, q of x cos and x sin.
struct BeatSums {
  double swing = 0;  ///< w (c^2 + s^2)
  double beat = 0;   ///< w (p^2 + q^2)
  double cross = 0;  ///< w (s p - c q)
  double noise = 0;  ///< w^2 (c^2 + s^2) variance

  void operator+=(const BeatSums& o) {
    swing += o.swing;
    beat += o.beat;
    cross += o.cross;
    noise += o.noise;
  }
};

struct Step {
  double frequency = 0;  ///< Hz
  double error = std::numeric_limits<double>::infinity();
};

class Newton {
 public:
  Newton(const SegmentSums& sums, int drift_order, const Team& team) : s_(sums), drift_(drift_order), team_(team) {}

  Step step(double frequency) {
    const HarmonicFit fit = harmonic_fit(s_, frequency, drift_, true);
    if (weight_.empty()) weigh(fit);
    std::vector<BeatSums> part((s_.pixels + PixelFit::run - 1) / PixelFit::run);
    for_runs(s_, team_, [&](std::size_t run, std::size_t begin, std::size_t count) { part[run] = beat_of(fit, begin, count); });
    BeatSums all;
    for (const auto& each : part) all += each;
    return solve(fit, all);
  }

 private:
  /// Noise of every pixel, and weights that follow its inverse but do not run away where a pixel is all but dead.
  void weigh(const HarmonicFit& fit) {
    variance_.resize(s_.pixels);
    for_runs(s_, team_, [&](std::size_t, std::size_t begin, std::size_t count) {
      PixelFit pixels;
      fit_pixels_with_variance(s_, fit, begin, count, pixels);
      for (std::size_t i = 0; i < count; ++i) variance_[begin + i] = static_cast<float>(pixels.variance[i]);
    });
    std::vector<float> sorted;
    for (const float v : variance_)
      if (std::isfinite(v)) sorted.push_back(v);
    float typical = 0;
    if (!sorted.empty()) {
      std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
      typical = sorted[sorted.size() / 2];
    }
    weight_.resize(s_.pixels);
    for (std::size_t p = 0; p < s_.pixels; ++p) {
      if (!std::isfinite(variance_[p])) weight_[p] = 0;
      else weight_[p] = typical > 0 ? 2 * typical / (variance_[p] + typical) : 1;
    }
  }

  BeatSums beat_of(const HarmonicFit& fit, std::size_t begin, std::size_t count) const {
    PixelFit swing, beat;
    fit_pixels(s_, fit, fit.first_harmonic(), 2, begin, count, swing);
    fit_pixels(s_, fit, fit.size() - 2, 2, begin, count, beat);
    BeatSums sum;
    for (std::size_t i = 0; i < count; ++i) {
      const double w = static_cast<double>(weight_[begin + i]);
      if (w == 0) continue;
      const double c = swing.value[i], s = swing.value[PixelFit::run + i], p = beat.value[i], q = beat.value[PixelFit::run + i];
      const double power = c * c + s * s;
      sum += {w * power, w * (p * p + q * q), w * (s * p - c * q), w * w * power * static_cast<double>(variance_[begin + i])};
    }
    return sum;
  }

  /// Noise swings, too, but does not beat more than it swings: that share is taken from the power before dividing by it.
  Step solve(const HarmonicFit& fit, const BeatSums& all) const {
    if (!(all.swing > 0)) return {};
    const auto a = static_cast<Eigen::Index>(fit.first_harmonic()), b = static_cast<Eigen::Index>(fit.size()) - 2;
    const double swing_noise = fit.covariance(a, a) + fit.covariance(a + 1, a + 1);
    const double beat_noise = fit.covariance(b, b) + fit.covariance(b + 1, b + 1);
    const double noise = (all.beat - all.cross * all.cross / all.swing) * swing_noise / beat_noise;
    const double signal = std::max(all.swing - noise, 0.02 * all.swing);
    return {all.cross / signal / (turn * fit.half), std::sqrt(all.noise * beat_noise / 2) / signal / (turn * fit.half)};
  }

  const SegmentSums& s_;
  int drift_;
  const Team& team_;
  std::vector<float> weight_, variance_;
};

}  // namespace

FrequencyFit refine_frequency(const SegmentSums& sums, int drift_order, const Team& team) {
  const double time = sums.time.back() - sums.time.front();
  const double reach = std::max(0.02 * sums.frequency, 2 / time);
  const double start = segments_in_step(sums, reach);
  Newton newton(sums, drift_order, team);
  FrequencyFit result{start, 0};
  for (int turns = 0; turns < 12; ++turns) {
    const Step step = newton.step(result.frequency);
    result.error = step.error;
    if (!std::isfinite(step.error)) break;
    const double change = std::clamp(step.frequency, -0.25 / time, 0.25 / time);
    result.frequency += change;
    if (std::abs(change) < std::max(1e-2 * step.error, 1e-13 * result.frequency)) break;
  }
  if (std::isfinite(result.error) && std::abs(result.frequency - sums.frequency) < reach && result.error < 0.25 / time) return result;
  return {sums.frequency, std::numeric_limits<double>::infinity()};
}

}  // namespace arenite::thermography
