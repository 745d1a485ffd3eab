#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "statistics/least_squares.hpp"
#include "thermal/thermography/step/step_load.hpp"
#include "thermal/thermography/step/step_rise.hpp"

namespace arenite::thermography {

/// How what a fit leaves goes together, from frame to frame and from pixel to pixel.
struct ResidualCorrelation {
  std::vector<double> lag;  ///< of a pixel with itself so many frames later, from 1 on, until it is lost in noise
  double pixels = 1;        ///< as many independent pixels vary as much together

  /// Variance of the weighed sum of a pixel's frames over that in white noise.
  double widening(const statistics::Matrix& weight) const;
};

/// Mean square of so many normal numbers that lies `deviations` above what is expected, as a normal number's would
/// (Wilson and Hilferty 1931).
double chi_squared_above(double numbers, double deviations);

/// Frames first .. first + count - 1 on one side of a step and the functions that pixels follow there, orthonormal over
/// these frames: a number of the fit is a weighed sum of values. Heights and slopes are those of the functions at the
/// step.
struct StepSide {
  std::size_t first = 0, count = 0;
  double relaxation = 0;             ///< s in which an exponential beside the polynomial falls to 1/e; 0: there is none
  statistics::Matrix weight;         ///< frames x functions
  statistics::Matrix height, slope;  ///< columns
  double onward = 0;                 ///< share of the jump by which the exponential goes on in its direction after it
  double misfit = 0;  ///< squared error of the height by what is not fitted, over the variance of white noise

  statistics::Matrix height_weights() const { return weight * height; }
};

/// Both sides of a step, the one before it first, with what the pixels' noise does there.
struct StepSides {
  std::array<StepSide, 2> side;
  ResidualCorrelation noise;
  double evidence =
      0;  ///< mean square of the pixels' jumps over what noise alone would make them; infinite without noise
  std::size_t frames() const { return side[0].count + side[1].count; }
  std::size_t functions() const { return side[0].height.rows() + side[1].height.rows(); }
  double freedom() const { return static_cast<double>(frames()) - static_cast<double>(functions()); }
  /// Variance of the jump over that of a frame's white noise.
  double variance() const;
};

/// Sides of a step at `step` (s) with the window, rise and polynomials of the options, without the frames of `gap`.
/// Heat that flows after the step, or a camera that warms up, makes pixels relax exponentially: where the pixels of
/// `series` (pixels x frames, each weighed by its noise) show by more than their noise that they do, an exponential in
/// the time that fits them best is added to a side. At `jumps` (s) pixels have another level from there on, each its
/// own. Throws InputError for a side with too few frames.
StepSides step_sides(statistics::Matrix series, const std::vector<double>& time, double step, const StepGap& gap,
                     const StepOptions& options, const std::vector<double>& jumps = {});

}  // namespace arenite::thermography
