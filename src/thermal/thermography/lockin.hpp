#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/thread_count.hpp"
#include "model/film.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

struct LockinOptions {
  double frequency = 0;  ///< of the load, Hz
  bool refine = true;    ///< find the frequency on the film, near the given one
  int drift_order = 4;   ///< of the polynomial in time that every pixel may drift by, 0 to 8; that of 4 follows a
                         ///< warm-up of a fifth of the film to 1 %
  int harmonics = 2;     ///< of the load frequency, 1 to 4; those above the Nyquist frequency are left out
  AmplitudeConvention convention = AmplitudeConvention::amplitude;
  /// Phase of the load, rad: the load is largest when 2 pi f t equals it, t in s after the first frame. Without it the
  /// phase is found on the film up to half a turn, see `reference_phase`.
  std::optional<double> reference_phase;
  int threads = Threads{}.threads;
  Progress progress;
};

/// Lock-in of a film, in one pass: in every pixel, least squares of a polynomial in time and of harmonics of the load
/// frequency, at the times of the frames, with the frequency refined on all pixels together. Standard errors are those
/// of the noise as it is beside the load's frequency. Throws InputError for a load frequency at or above the Nyquist
/// frequency, less than one cycle, so few cycles that drift and load cannot be told apart, fewer frames than unknowns,
/// or a film in which nothing changes; and, where the frequency is to be refined, for a film that oscillates at another
/// frequency and not there. Empty maps if `progress` stopped it.
LockinMaps lock_in(FilmSource& film, const LockinOptions& options);

/// 1, cosine and sine of the phase 2 pi f t, and of twice the phase; or what a fit has of them.
using Harmonics = std::array<double, 5>;

/// Writes into the maps what is fitted to a pixel, of which the fit leaves `noise`; `spread` is the standard error of
/// its cosine and sine over that.
void put(LockinMaps& maps, std::size_t pixel, const Harmonics& fitted, double noise, double spread);

/// As the plain transform does it: mean image subtracted, Fourier sum at the bin next to the frequency, frames evenly
/// spaced. Off a bin, and with drift, amplitudes are wrong by up to 1 - 2/pi; kept to reproduce results found this way.
LockinMaps nearest_bin_transform(FilmSource& film, const LockinOptions& options);

/// The phase in which the amplitude of all pixels together is largest: it maximises the sum of squares of what is in
/// phase with it. No pixel counts for more than three times the median one, for rims that move past pixels change them
/// by far more than a load warms them. The film alone does not distinguish it from its opposite; of the two the one is
/// taken with which pixels warm on the mean when the load rises, as packed grains do, whose mean stress is
/// compression.
double reference_phase(const std::vector<double>& cosine, const std::vector<double>& sine);

/// Of every pixel relative to that of the load, rad in [-pi, pi].
std::vector<float> phase_after_load(const LockinMaps& maps);

/// Length over which heat diffuses within a cycle, sqrt(D/(pi f)), m; the signal is adiabatic where this is far below a
/// pixel and a grain. `diffusivity` in m^2/s, `frequency` in Hz.
inline double diffusion_length(double diffusivity, double frequency) {
  return std::sqrt(diffusivity / (std::numbers::pi * frequency));
}

/// Whether heat stays where it came to be within a cycle of the load.
struct Adiabatic {
  double length = 0, pixel = 0;  ///< that heat diffuses, and the side of a pixel, m; no pixel: unknown

  /// `diffusivity` of heat in the grains, m^2/s; `frequency` of the load, Hz.
  Adiabatic(double diffusivity, double frequency, double side = 0)
      : length(diffusion_length(diffusivity, frequency)),
        pixel(side) {}
  /// Share of its amplitude that the finest detail of a picture loses to it: stripes of two pixels' length have 1/|1 +
  /// i D k^2/(2 pi f)| of theirs.
  double lost() const;
  /// At a fifth of a pixel the finest detail loses 2 % of its amplitude and lags by 11 degrees.
  bool holds() const { return length <= pixel / 5; }
  std::string sentence() const;  ///< what to say where it does not hold
};

}  // namespace arenite::thermography
