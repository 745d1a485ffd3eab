#include "thermal/thermography/refine_frequency.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/median.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/segment_phasors.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

constexpr double turn = 2 * std::numbers::pi;

/// Form by which cosines, then sines, of a frequency at the middles of all segments give its power.
Matrix products(const SegmentSums& s) {
  std::vector<Matrix> fits;
  for (std::size_t k = 0; k < s.segments(); ++k) fits.push_back(segment_fit(s, k));
  Matrix sum(2 * s.segments(), 2 * s.segments()), phasors(2 * s.segments(), 2 * chunk);
  for_some_chunks(s, 64, [&](std::size_t begin, std::size_t count) {
    std::size_t used = 0;
    for (std::size_t p = begin; p < begin + count; ++p)
      if (phasors_of(s, fits, p, phasors, used)) used += 2;
    const Matrix some = phasors.part(0, used);
    sum += times_transposed(some, some);
  });
  return sum;
}

/// Where the phasors of the segments, each by itself, are most in step: the frequency of the band to about a tenth of a
/// cycle over the film. Looks at some thousand pixels.
double segments_in_step(const SegmentSums& s, const SearchBand& band) {
  const double time = s.time.back() - s.time.front(), segment = time / static_cast<double>(s.segments());
  const double below = std::min(s.frequency - band.low, 0.4 / segment),
               above = std::min(band.high - s.frequency, 0.4 / segment), step = 1 / (8 * time);
  const Matrix product = products(s);
  Matrix phase(product.rows(), 1);
  const auto power = [&](double frequency) {
    for (std::size_t k = 0; k < s.segments(); ++k) {
      const double angle = turn * frequency * s.centre[k];
      phase(k, 0) = std::cos(angle), phase(s.segments() + k, 0) = std::sin(angle);
    }
    return statistics::dot(phase.column(0), (product * phase).column(0), phase.size());
  };
  int best = 0;
  double most = -1;
  for (int k = -static_cast<int>(below / step); k <= static_cast<int>(above / step); ++k)
    if (const double p = power(s.frequency + k * step); p > most) most = p, best = k;
  return s.frequency +
         (best + peak_between(power(s.frequency + (best - 1) * step), most, power(s.frequency + (best + 1) * step))) *
             step;
}

constexpr double strong_signal = 0.1;  // as if it were noise: a signal of three times the noise loses half its weight

/// What a Newton step adds up over pixels of weight w: with c, s of cos and sin, p, q of x cos and x sin.
struct BeatSums {
  double power = 0;  ///< w (c^2 + s^2)
  double beat = 0;   ///< w (p^2 + q^2)
  double cross = 0;  ///< w (s p - c q)
  double noise = 0;  ///< w^2 (c^2 + s^2) variance

  void operator+=(const BeatSums& o) { power += o.power, beat += o.beat, cross += o.cross, noise += o.noise; }
};

using Weighings = std::array<BeatSums, 2>;  // by noise alone, and with strong signals held back

class Newton {
 public:
  Newton(const SegmentSums& sums, int drift_order, const ThreadPool& pool)
      : s_(sums),
        drift_(drift_order),
        team_(pool) {}

  /// By how much the frequency is off; looks at one run of pixels in `every`.
  FrequencyFit step(double frequency, std::size_t every) {
    const HarmonicFit fit = harmonic_fit(s_, frequency, drift_, true);
    if (typical_ < 0) typical_ = typical_variance(fit, every);
    std::vector<Weighings> part(runs());
    for_runs(s_, team_, [&](std::size_t run, std::size_t begin, std::size_t count) {
      if (run % every == 0) part[run] = beat_of(fit, begin, count);
    });
    Weighings all;
    for (const auto& each : part) all[0] += each[0], all[1] += each[1];
    FrequencyFit step = solve(fit, all[0]);
    step.of_model = std::abs(step.frequency - solve(fit, all[1]).frequency);
    return step;
  }

  std::size_t runs() const { return (s_.pixels + PixelFit::run - 1) / PixelFit::run; }

 private:
  double typical_variance(const HarmonicFit& fit, std::size_t every) const {
    std::vector<double> variance;
    PixelFit pixels;
    for (std::size_t begin = 0; begin < s_.pixels; begin += every * PixelFit::run) {
      const std::size_t count = std::min(PixelFit::run, s_.pixels - begin);
      fit_pixels_with_variance(s_, fit, begin, count, pixels);
      for (std::size_t i = 0; i < count; ++i)
        if (std::isfinite(pixels.variance[i])) variance.push_back(pixels.variance[i]);
    }
    return median(std::move(variance));
  }

  /// Weights follow the inverse of the noise but do not run away where a pixel is all but dead. A pixel past which rims
  /// move has most power, with overtones that are not fitted: what the frequency changes by where strong signals weigh
  /// less is in its error.
  Weighings beat_of(const HarmonicFit& fit, std::size_t begin, std::size_t count) const {
    PixelFit pixels;
    fit_pixels_with_variance(s_, fit, begin, count, pixels);
    const double* c = pixels.value.data() + fit.harmonic(1) * PixelFit::run;
    const double *s = c + PixelFit::run, *p = s + PixelFit::run, *q = p + PixelFit::run;
    Weighings sum;
    for (std::size_t i = 0; i < count; ++i) {
      const double variance = pixels.variance[i];
      if (!std::isfinite(variance)) continue;
      const double power = c[i] * c[i] + s[i] * s[i], beat = p[i] * p[i] + q[i] * q[i],
                   cross = s[i] * p[i] - c[i] * q[i];
      const auto weighed = [&](double noise) -> BeatSums {
        const double w = typical_ > 0 ? 2 * typical_ / (noise + typical_) : 1;
        return {w * power, w * beat, w * cross, w * w * power * variance};
      };
      sum[0] += weighed(variance), sum[1] += weighed(variance + strong_signal * power);
    }
    return sum;
  }

  /// Noise has power, too, but no more beat than power: that share is taken from the power before dividing by it.
  FrequencyFit solve(const HarmonicFit& fit, const BeatSums& all) const {
    if (!(all.power > 0)) return {0, std::numeric_limits<double>::infinity(), 0};
    const std::size_t a = fit.harmonic(1), b = fit.size() - 2;
    const double power_noise = fit.covariance(a, a) + fit.covariance(a + 1, a + 1);
    const double beat_noise = fit.covariance(b, b) + fit.covariance(b + 1, b + 1);
    const double noise = (all.beat - all.cross * all.cross / all.power) * power_noise / beat_noise;
    const double signal = std::max(all.power - noise, 0.02 * all.power);
    return {all.cross / signal / (turn * fit.half), std::sqrt(all.noise * beat_noise / 2) / signal / (turn * fit.half),
            0};
  }

  const SegmentSums& s_;
  int drift_;
  const ThreadPool& team_;
  double typical_ = -1;
};

/// What an oscillation of this frequency explains in some thousand pixels, each weighed by its noise.
double explained(const SegmentSums& s, double frequency, int drift_order) {
  const HarmonicFit fit = harmonic_fit(s, frequency, drift_order, false);
  const std::size_t own = fit.harmonic(1);
  const double cc = fit.covariance(own, own), cs = fit.covariance(own, own + 1) + fit.covariance(own + 1, own),
               ss = fit.covariance(own + 1, own + 1);
  const double determinant = cc * ss - fit.covariance(own, own + 1) * fit.covariance(own + 1, own);
  double sum = 0;
  PixelFit pixels;
  for_some_chunks(s, 64, [&](std::size_t begin, std::size_t count) {
    fit_pixels_with_variance(s, fit, begin, count, pixels);
    const double freedom = static_cast<double>(s.time.size() - fit.size());
    for (std::size_t i = 0; i < count; ++i) {
      const double c = pixels.value[own * PixelFit::run + i], sn = pixels.value[(own + 1) * PixelFit::run + i];
      const double power = (ss * c * c - cs * c * sn + cc * sn * sn) / determinant, rest = freedom * pixels.variance[i];
      if (power + rest > 0 && std::isfinite(power + rest)) sum += power / (power + rest);
    }
  });
  return sum;
}

/// The best of the frequencies an eighth of a cycle over the film apart.
double best_fitting(const SegmentSums& s, const SearchBand& band, int drift_order) {
  const double step = 1 / (8 * film_length(s.time));
  double best = s.frequency, most = explained(s, s.frequency, drift_order);
  for (int k = 0; band.low + k * step <= band.high; ++k)
    if (const double share = explained(s, band.low + k * step, drift_order); share > most)
      most = share, best = band.low + k * step;
  return best;
}

}  // namespace

SearchBand search_band(const std::vector<double>& time, double frequency) {
  const double length = film_length(time);
  if (frequency * length < 2) return {};
  const double reach = std::max(0.02 * frequency, 2 / length);
  return {std::max(frequency - reach, 1 / length), std::min(frequency + reach, nyquist_frequency(time) - 0.5 / length)};
}

double frequencies_in(const SearchBand& band, const std::vector<double>& time) {
  return band.empty() ? 1 : 1 + 2 * (band.high - band.low) * film_length(time);
}

FrequencyFit refine_frequency(const SegmentSums& sums, int drift_order, const ThreadPool& pool) {
  const SearchBand band = search_band(sums.time, sums.frequency);
  const FrequencyFit as_given{sums.frequency, std::numeric_limits<double>::infinity(), 0};
  if (band.empty()) return as_given;
  const double time = sums.time.back() - sums.time.front();
  Newton newton(sums, drift_order, pool);
  FrequencyFit result{segments_show_load(sums) ? segments_in_step(sums, band) : best_fitting(sums, band, drift_order),
                      0, 0};
  std::size_t every = newton.runs() >= 64 ? 8 : 1;
  for (int turns = 0; turns < 12; ++turns) {
    const FrequencyFit step = newton.step(result.frequency, every);
    result.error = step.error;
    result.of_model = step.of_model;
    if (!std::isfinite(step.error)) break;
    const double change = std::clamp(step.frequency, -0.25 / time, 0.25 / time);
    result.frequency += change;
    if (!(result.frequency > band.low && result.frequency < band.high)) return as_given;
    const bool converged = std::abs(change) < std::max(1e-2 * step.error, 1e-13 * result.frequency);
    if (every == 1 && (converged || std::abs(change) < 1e-4 / time)) break;
    if (converged || std::abs(change) < 0.03 / time) every = 1;
  }
  return result.error < 0.25 / time ? result : as_given;
}

}  // namespace arenite::thermography
