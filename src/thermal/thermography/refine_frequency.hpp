#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "model/film.hpp"
#include "statistics/least_squares.hpp"
#include "thermal/thermography/harmonic_fit.hpp"

namespace arenite::thermography {

/// A frequency with its standard error, Hz.
struct FrequencyFit {
  double frequency = 0;
  double error = 0;     ///< by white noise
  double of_model = 0;  ///< by what no single frequency explains
};

/// Where a frequency is looked for: within 2 % or two cycles over the film, but never below one cycle over it or above
/// the Nyquist frequency. Below two cycles load and drift are too alike for a frequency to be found.
struct SearchBand {
  double low = 0, high = 0;  ///< Hz
  bool empty() const { return !(low < high); }
};

SearchBand search_band(const std::vector<double>& time, double frequency);

/// How many independent frequencies there are in it, with what a search between them finds more.
double frequencies_in(const SearchBand& band, const std::vector<double>& time);

/// The frequency of the band at which all pixels together have most power: first where the segments of some thousand
/// pixels are most in step or, in films of few cycles, where a fit to these pixels explains most, then Newton steps of
/// the least-squares problem of all pixels, each weighed by its noise. The error is the Cramer-Rao bound for white
/// noise. A film that shows no oscillation in the band keeps the frequency of the sums, with an error of infinity.
FrequencyFit refine_frequency(const SegmentSums& sums, int drift_order, const ThreadPool& pool);

/// Throws InputError for a film of so few cycles that drift can do nearly all that the load does.
void refuse_too_few_cycles(const HarmonicFit& fit, const SegmentSums& sums);

/// Gives the maps what distinguishes a load at their frequency from noise: its ratio, chance, share in one phase, the
/// frequency's error and at which other frequency the film oscillates. Throws InputError where the frequency was
/// `refined` on the film and nothing is found there but at another, or is a multiple of one with a far larger
/// amplitude.
void judge_amplitude(const SegmentSums& sums, const HarmonicFit& fit, const std::optional<FrequencyFit>& refined,
                     LockinMaps& maps);

/// Where a parabola through three values one step apart, of which the middle one is the largest, has its peak: steps
/// from the middle.
inline double peak_between(double before, double at, double after) {
  const double curve = before - 2 * at + after;
  return curve < 0 ? std::clamp(0.5 * (before - after) / curve, -0.5, 0.5) : 0;
}

/// The pixels of a film of which every value is kept, without drift, over their spread, and under a window that keeps a
/// strong line to itself. They show the whole band, where sums of segments show the neighbourhood of one frequency
/// only, into which what is further away may leak.
class WatchedPixels {
 public:
  explicit WatchedPixels(const SegmentSums& sums);

  /// Whether there is a line at `frequency` (Hz): these pixels oscillate there in one phase more than beside it.
  bool have_line(double frequency) const;

  /// The half, third or quarter of `frequency` at which the pixels' amplitude is at least twice as large: then it is a
  /// multiple of the load's.
  std::optional<double> stronger_part(double frequency) const;

  /// The frequency at which the pixels' common amplitude in one phase is largest, anywhere between two cycles over the
  /// film and the Nyquist frequency; none where nothing stands clearly above its neighbourhood, or has one phase.
  std::optional<double> strongest_line() const;

 private:
  /// Of all pixels at one frequency, from sums over frames of value times e^(2 pi i f t).
  struct Line {
    double power = 0, in_one_phase = 0;  ///< sum of |z|^2, and |sum of z^2|
  };
  std::vector<Line> lines_at(const std::vector<double>& frequencies) const;

  const std::vector<double>& time_;
  statistics::FloatMatrix value_;  ///< pixels x frames
};

}  // namespace arenite::thermography
