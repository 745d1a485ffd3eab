#include "thermal/thermography/judge_amplitude.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/problems.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/refine_frequency.hpp"
#include "thermal/thermography/shared_noise.hpp"

namespace arenite::thermography {
namespace {

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
  const Band band{fit.frequency * length, 1 + 0.5 * static_cast<double>(fit.drift - 1),
                  nyquist_frequency(s.time) * length - 1};
  const std::size_t values = std::min(s.time.size(), s.segments() * (1 + s.functions)),
                    taken = fit.slow() + 2 * fit.harmonics;
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

/// Sums over pixels of phasors z = cos + i sin, each over its error in white noise of the pixel's residual.
struct PhasorSums {
  double power = 0;                 ///< |z|^2
  std::complex<double> square = 0;  ///< z^2: nothing where phases are of all kinds
  std::complex<double> along = 0;   ///< z times the conjugate of the load's
  void add(std::complex<double> z, std::complex<double> load) {
    power += std::norm(z), square += z * z, along += z * std::conj(load);
  }
};

/// Makes the errors of cos and sin equal and independent, by Cholesky's triangle of their covariance.
struct Whitening {
  double c, cs, s;

  Whitening(const HarmonicFit& fit, std::size_t column)
      : c(std::sqrt(fit.covariance(column, column))),
        cs(fit.covariance(column + 1, column) / c),
        s(std::sqrt(fit.covariance(column + 1, column + 1) - cs * cs)) {}
  std::complex<double> operator()(double cosine, double sine) const {
    return {cosine / c, (sine - cs / c * cosine) / s};
  }
};

struct Seen {
  PhasorSums load;
  std::vector<PhasorSums> beside;
  std::vector<std::vector<double>> power;  ///< |z|^2/2 of every pixel, beside
  std::size_t pixels = 0;
};

/// The load's phasor is taken from the fit of all frequencies together: so a strong line further away, which leaks into
/// all of them alike, is not seen at this one.
Seen look(const SegmentSums& s, const HarmonicFit& fit, const HarmonicFit& wide) {
  const std::size_t sides = wide.beside.size(), own = wide.harmonic(1), all = 1 + sides;
  std::vector<Whitening> white;
  for (std::size_t k = 0; k < all; ++k) white.emplace_back(wide, own + 2 * k);
  Seen seen{{}, std::vector<PhasorSums>(sides), std::vector<std::vector<double>>(sides), 0};
  PixelFit base, phasors;
  for_some_chunks(s, 64, [&](std::size_t begin, std::size_t count) {
    fit_pixels_with_variance(s, fit, begin, count, base);
    fit_pixels(s, wide, own, 2 * all, begin, count, phasors);
    for (std::size_t i = 0; i < count; ++i) {
      const double noise = std::sqrt(base.variance[i]);
      if (!(noise > 0) || !std::isfinite(noise)) continue;
      ++seen.pixels;
      std::complex<double> load;
      for (std::size_t k = 0; k < all; ++k) {
        const auto z = white[k](phasors.value[2 * k * PixelFit::run + i] / noise,
                                phasors.value[(2 * k + 1) * PixelFit::run + i] / noise);
        if (k == 0) load = z;
        (k == 0 ? seen.load : seen.beside[k - 1]).add(z, load);
        if (k > 0) seen.power[k - 1].push_back(std::norm(z) / 2);
      }
    }
  });
  return seen;
}

/// Variance of the noise in the median pixel, from those frequencies that no line of the instrument lifts far above the
/// others.
double typical_noise(const Seen& seen) {
  const auto powers = mapped(seen.beside, &PhasorSums::power);
  const double bound = 5 * median(powers);
  std::vector<double> own(seen.pixels, 0);
  double used = 0;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    if (powers[k] > bound) continue;
    for (std::size_t i = 0; i < own.size(); ++i) own[i] += seen.power[k][i];
    ++used;
  }
  const double median_of_chi_squared =
      std::pow(1 - 1 / (9 * used), 3);  // with 2 `used` degrees of freedom, over these (Wilson and Hilferty 1931)
  return median(std::move(own)) / used / median_of_chi_squared;
}

/// Noise along the pattern of the load's amplitudes, which independent pixels would have as strong as any one of them.
/// The looked-at pixels show what they share; all `pixels` share as much, each pair.
double noise_together(const Seen& seen, double noise, std::size_t pixels) {
  double along = 0;
  for (const PhasorSums& each : seen.beside) along += std::norm(each.along) / static_cast<double>(seen.beside.size());
  const double shared = along / (2 * noise * seen.load.power) - 1;
  // A dozen frequencies show independent pixels as twice as noisy once in three hundred films.
  return shared > 1 ? 1 + shared * static_cast<double>(pixels - 1) / static_cast<double>(seen.pixels - 1) : 1;
}

/// Compares the amplitude of some thousand pixels with that at up to twelve frequencies beside it, some cycles over the
/// film away, which neither drift nor harmonics reach: noise of real cameras is neither white nor each pixel's own, for
/// frames follow on each other, rows and whole frames flicker together, and the electronics have lines. Lines far above
/// their neighbours are not counted as noise of the load's frequency, but do count where chance is judged. `fit` is
/// that of the maps, `tried` the number of independent frequencies among which its own was found. Fills in the maps'
/// noise ratio, chance and share in one phase (a load warms and cools all of a sample at once; an interference that
/// goes over the rows as they are read out does not); returns the variance of all pixels' common amplitude over that of
/// pixels whose noise is their own.
double noise_around(const SegmentSums& s, const HarmonicFit& fit, double tried, const ThreadPool& pool,
                    LockinMaps& maps) {
  const double length = film_length(s.time);
  const HarmonicFit wide = harmonic_fit(s, fit.frequency, static_cast<int>(fit.drift) - 1, false, 0.5 / length,
                                        frequencies_beside(s, fit, length));
  const Seen seen = look(s, fit, wide);
  measure_shared_noise(s, wide, pool, maps);
  const double pixels = static_cast<double>(seen.pixels), sides = static_cast<double>(wide.beside.size()),
               in_phase = std::abs(seen.load.square);
  if (seen.pixels == 0) return 1;  // of pixels without noise, or that are no numbers, nothing is known
  double noise = 1, together = 1, chance = 0;
  if (sides > 0) {
    maps.noise_ratio = typical_noise(seen);
    double square = 0;
    noise = 0;
    for (const PhasorSums& each : seen.beside)
      noise += each.power / (2 * pixels) / sides, square += std::abs(each.square) / sides;
    if (seen.pixels > 1) together = noise_together(seen, noise, s.pixels);
    // Of one source that all pixels share, |z^2| is exponential, and that of few frequencies beside is known no better;
    // of many sources its tail is shorter.
    chance = tried * std::pow(1 + in_phase / (sides * square), -sides);
  } else {
    chance = tried * std::exp(-in_phase / std::sqrt(2 * std::numbers::pi * pixels));  // white noise of each pixel's own
  }
  maps.chance = std::min(1.0, chance);
  const double above = seen.load.power - 2 * pixels * noise;
  maps.one_phase = above > 0 ? std::min(1.0, in_phase / above) : 0;
  return together;
}

}  // namespace

bool shows_load(const LockinMaps& maps) {
  constexpr double level = 0.01, one_phase = 0.5;
  return maps.chance < level && maps.one_phase >= one_phase;
}

/// Seven times the error of a film of many cycles: nothing that such maps show would be the load's.
void refuse_too_few_cycles(const HarmonicFit& fit, const SegmentSums& s) {
  if (fit.inflation(s.time.size()) < 50) return;
  const double length = film_length(s.time);
  throw refusal(
      "the film of {:.4g} s holds {:.3g} cycles of {:.6g} Hz, too few to separate the load from a drift of order {}; "
      "use a lower drift order, or give a longer film",
      length, length * fit.frequency, fit.frequency, fit.drift - 1);
}

void judge_amplitude(const SegmentSums& s, const HarmonicFit& fit, const std::optional<FrequencyFit>& refined,
                     const WatchedPixels& watched, const ThreadPool& pool, LockinMaps& maps) {
  const double together =
      noise_around(s, fit, refined ? frequencies_in(search_band(s.time, s.frequency), s.time) : 1, pool, maps);
  if (refined)
    maps.frequency_error = std::hypot(refined->error * std::sqrt(maps.noise_ratio * together), refined->of_model);
  const bool clear = shows_load(maps) && watched.have_line(fit.frequency);
  const auto elsewhere = clear ? watched.stronger_part(fit.frequency) : watched.strongest_line();
  if (!elsewhere || std::abs(*elsewhere - fit.frequency) * film_length(s.time) < 0.7) return;  // the same line
  maps.other_frequency = *elsewhere;
  if (!clear) maps.chance = 1;  // it leaks there from the other
  if (!refined) return;
  const int digits = static_cast<int>(std::ceil(std::log10(*elsewhere * film_length(s.time)))) +
                     2;  // a hundredth of a cycle over the film
  const std::string there = fmt::format("{:.{}g} Hz", *elsewhere, std::max(digits, 3));
  if (clear)
    throw refusal(
        "the amplitude is larger at {} than at {:.6g} Hz, which is a multiple; give the frequency of the load, {}",
        there, s.frequency, there);
  throw refusal(
      "the film shows only noise at {:.6g} Hz, but an oscillation at {}; if that is the load, give this frequency",
      s.frequency, there);
}

}  // namespace arenite::thermography
