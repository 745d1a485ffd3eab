#pragma once
#include <optional>
#include <vector>

namespace arenite::thermography {

/// The cycle of a load's own signal.
struct LoadSignal {
  double frequency = 0, frequency_error = 0;  ///< Hz
  double phase = 0;                           ///< rad: the signal is largest when 2 pi f t equals it
};

/// The cycle that takes most of a signal's squares, between half and twice the frequency that is given, by least
/// squares of a straight line, cosine and sine at the times of its frames (s). Nothing where it takes less than half of
/// what the line leaves (a square wave's takes 0.81), and where the signal holds less than two cycles.
std::optional<LoadSignal> fit_load_signal(const std::vector<double>& time, const std::vector<double>& signal,
                                          double given);

}  // namespace arenite::thermography
