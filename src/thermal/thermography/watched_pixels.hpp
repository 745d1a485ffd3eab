#pragma once
#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// The pixels of a film of which every value is kept, without drift, over their spread, and under a window that keeps a
/// strong line to itself. They show the whole band, where sums of segments show the neighbourhood of one frequency only, into
/// which what is further away may leak.
class WatchedPixels {
 public:
  explicit WatchedPixels(const SegmentSums& sums);

  /// Whether there is a line at `frequency` (Hz): these pixels swing there in one phase more than beside it.
  bool have_line(double frequency) const;

  /// The half, third or quarter of `frequency` at which the pixels swing at least twice as much: then it is a multiple of the load's.
  std::optional<double> stronger_part(double frequency) const;

  /// The frequency at which the pixels swing most in one phase, anywhere between two cycles over the film and the Nyquist
  /// frequency; none where nothing stands clearly above what swings around it, or has one phase.
  std::optional<double> strongest_line() const;

 private:
  /// Sums over frames of value times e^(2 pi i f t): pixels x frequencies.
  Eigen::MatrixXcf swings(const std::vector<double>& frequencies) const;

  const std::vector<double>& time_;
  Eigen::MatrixXf value_;           ///< pixels x frames
};

}  // namespace arenite::thermography
