#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace arenite::peridynamics {

/// What a long solve tells on its way.
struct Progress {
  double share = 0;        ///< of the work that is done, 0 to 1, never falling: for a progress bar
  int iterations = 0;      ///< of the static solver, or steps, so far
  double residual = 0;     ///< relative, the latest
  std::size_t broken = 0;  ///< bonds, where they may break
  double strain = 0;       ///< that the sample has reached, where bonds may break
  double stress = 0;       ///< the same for the stress, Pa
};

/// Called between iterations (of dynamics: every 20 steps) and after each round of breaking bonds; false stops the
/// work, and what was reached is handed back with the ending `stopped`. Empty: nobody watches.
using Watch = std::function<bool(const Progress&)>;

/// Tells a watch how far a residual has come down, on a logarithmic scale from its first value to the tolerance.
class Reporter {
 public:
  Reporter(const Watch& watch, double tolerance) : watch_(watch), tolerance_(tolerance) {}

  bool goes_on(int iterations, double residual) {
    if (!watch_) return true;
    if (first_ == 0) first_ = residual;
    if (residual > 0 && first_ > tolerance_)
      share_ = std::clamp(std::log(first_ / residual) / std::log(first_ / tolerance_), share_, 1.0);
    return watch_({share_, iterations, residual, 0, 0, 0});
  }

 private:
  const Watch& watch_;
  double tolerance_, first_ = 0, share_ = 0;
};

}  // namespace arenite::peridynamics
