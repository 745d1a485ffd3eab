#pragma once
#include <optional>
#include <vector>

#include "statistics/least_squares.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

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
