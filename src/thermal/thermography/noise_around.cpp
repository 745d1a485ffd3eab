#include "thermal/thermography/noise_around.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/median.hpp"
#include "thermal/thermography/frame_times.hpp"
#include "thermal/thermography/pixel_fit.hpp"

namespace arenite::thermography {

namespace {

using Eigen::Index;

/// Cycles over the film of all that is fitted but the frequencies beside.
struct Band {
  double cycles, least, most;
  bool has_room(double at, double clear) const {
    const double multiple = std::round(at / cycles);
    return at >= least && at <= most && (multiple < 2 || std::abs(at - multiple * cycles) >= clear);
  }
};

/// In half cycles over the film from the load's.
std::vector<int> frequencies_beside(const SegmentSums& s, const HarmonicFit& fit, double length) {
  const Band band{fit.frequency * length, 1 + 0.5 * static_cast<double>(fit.drift - 1), nyquist_frequency(s.time) * length - 1};
  const std::size_t values = std::min(s.time.size(), s.segments() * (1 + s.functions)), taken = fit.drift + 2 * fit.harmonics;
  const std::size_t most = std::min<std::size_t>(12, values / 2 > taken ? (values / 2 - taken) / 2 : 0);
  // Further than half the segments away, frequencies above and below would look alike in the segments' sums.
  const int reach = std::min(6, static_cast<int>(s.segments()) / 2 - 2);
  std::vector<int> beside;
  const auto add = [&](int halves, double clear) {
    if (beside.size() < most && band.has_room(band.cycles + 0.5 * halves, clear)) beside.push_back(halves);
  };
  for (int k = 1; k <= reach; ++k) add(-2 * k, 0.75), add(2 * k, 0.75);
  if (beside.size() >= 4) return beside;
  beside.clear();  // of few cycles, multiples are as close as their neighbours
  for (int k = 1; k <= reach; ++k) add(2 * k + 1, 0.4);
  return beside;
}

/// Sums over pixels of swings z = cos + i sin, each over its error in white noise of the pixel's residual.
struct Swing {
  double power = 0;                ///< |z|^2
  std::complex<double> square = 0; ///< z^2: nothing where phases are of all kinds
  std::complex<double> along = 0;  ///< z times the conjugate of the load's
  void add(std::complex<double> z, std::complex<double> load) { power += std::norm(z), square += z * z, along += z * std::conj(load); }
};

/// Makes the errors of cos and sin equal and independent.
Eigen::Matrix2d whitening(const HarmonicFit& fit, std::size_t column) {
  const Eigen::Matrix2d covariance = fit.covariance.block<2, 2>(static_cast<Index>(column), static_cast<Index>(column));
  return covariance.llt().matrixL().solve(Eigen::Matrix2d::Identity());
}

std::complex<double> whitened(const Eigen::Matrix2d& by, double cosine, double sine) {
  return {by(0, 0) * cosine + by(0, 1) * sine, by(1, 0) * cosine + by(1, 1) * sine};
}

struct Seen {
  Swing load;
  std::vector<Swing> beside;
  std::vector<std::vector<double>> power;  ///< |z|^2/2 of every pixel, beside
  std::size_t pixels = 0;
};

/// The load's swing is taken from the fit of all frequencies together: so a strong line further away, which leaks into all of
/// them alike, is not seen as a swing at this one.
Seen look(const SegmentSums& s, const HarmonicFit& fit, const HarmonicFit& wide) {
  const std::size_t sides = wide.beside.size(), own = wide.harmonic(1), all = 1 + sides;
  std::vector<Eigen::Matrix2d> white;
  for (std::size_t k = 0; k < all; ++k) white.push_back(whitening(wide, own + 2 * k));
  Seen seen{{}, std::vector<Swing>(sides), std::vector<std::vector<double>>(sides), 0};
  PixelFit base, swings;
  for_some_chunks(s, 64, [&](std::size_t begin, std::size_t count) {
    fit_pixels_with_variance(s, fit, begin, count, base);
    fit_pixels(s, wide, own, 2 * all, begin, count, swings);
    for (std::size_t i = 0; i < count; ++i) {
      const double noise = std::sqrt(base.variance[i]);
      if (!(noise > 0) || !std::isfinite(noise)) continue;
      ++seen.pixels;
      std::complex<double> load;
      for (std::size_t k = 0; k < all; ++k) {
        const auto z = whitened(white[k], swings.value[2 * k * PixelFit::run + i] / noise, swings.value[(2 * k + 1) * PixelFit::run + i] / noise);
        if (k == 0) load = z;
        (k == 0 ? seen.load : seen.beside[k - 1]).add(z, load);
        if (k > 0) seen.power[k - 1].push_back(std::norm(z) / 2);
      }
    }
  });
  return seen;
}

/// Variance of the noise in the median pixel, from those frequencies that no line of the instrument lifts far above the others.
double typical_noise(const Seen& seen) {
  std::vector<double> powers;
  for (const Swing& each : seen.beside) powers.push_back(each.power);
  const double bound = 5 * median(powers);
  std::vector<double> own(seen.pixels, 0);
  double used = 0;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    if (powers[k] > bound) continue;
    for (std::size_t i = 0; i < own.size(); ++i) own[i] += seen.power[k][i];
    ++used;
  }
  const double median_of_chi_squared = std::pow(1 - 1 / (9 * used), 3);  // with 2 `used` degrees of freedom, over these (Wilson and Hilferty 1931)
  return median(std::move(own)) / used / median_of_chi_squared;
}

/// Noise along the pattern of the load's swing, which independent pixels would have as strong as any one of them. The looked-at
/// pixels show what they share; all `pixels` share as much, each pair.
double noise_together(const Seen& seen, double noise, std::size_t pixels) {
  double along = 0;
  for (const Swing& each : seen.beside) along += std::norm(each.along) / static_cast<double>(seen.beside.size());
  const double shared = along / (2 * noise * seen.load.power) - 1;
  // A dozen frequencies show independent pixels as twice as noisy once in three hundred films.
  return shared > 1 ? 1 + shared * static_cast<double>(pixels - 1) / static_cast<double>(seen.pixels - 1) : 1;
}

}  // namespace

NoiseAround noise_around(const SegmentSums& s, const HarmonicFit& fit, double tried) {
  const double length = film_length(s.time);
  const HarmonicFit wide = harmonic_fit(s, fit.frequency, static_cast<int>(fit.drift) - 1, false, 0.5 / length, frequencies_beside(s, fit, length));
  const Seen seen = look(s, fit, wide);
  NoiseAround around;
  const double pixels = static_cast<double>(seen.pixels), sides = static_cast<double>(wide.beside.size()), swing = std::abs(seen.load.square);
  if (seen.pixels == 0) return around;  // no pixel shows noise
  double noise = 1;
  if (sides > 0) {
    around.ratio = typical_noise(seen);
    double square = 0;
    noise = 0;
    for (const Swing& each : seen.beside) noise += each.power / (2 * pixels) / sides, square += std::abs(each.square) / sides;
    if (seen.pixels > 1) around.together = noise_together(seen, noise, s.pixels);
    // Of one source that all pixels share, |z^2| is exponential, and that of few frequencies beside is known no better; of
    // many sources its tail is shorter.
    around.chance = tried * std::pow(1 + swing / (sides * square), -sides);
  } else {
    around.chance = tried * std::exp(-swing / std::sqrt(2 * std::numbers::pi * pixels));  // white noise of each pixel's own
  }
  around.chance = std::min(1.0, around.chance);
  const double above = seen.load.power - 2 * pixels * noise;
  around.one_phase = above > 0 ? std::min(1.0, swing / above) : 0;
  return around;
}

}  // namespace arenite::thermography
