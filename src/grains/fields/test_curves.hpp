#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grains/fields/loading.hpp"
#include "statistics/measured.hpp"

namespace arenite::fields {

/// Of a stage's curves (loading.hpp) those that tell of its test: its strain, and what answers to it.
struct TestCurves {
  std::string strain_name;  ///< "shear strain", "strain of the height", "strain of the width"
  bool sheared = false;    ///< along the sides: the ratio is shear over normal stress there, "mu"; else q over p of the
                           ///< sides, "q_over_p"
  bool confined = true;    ///< across its axis, too, and not drawn apart; else instead of the ratio there is the stress
                           ///< along the axis, Pa
  bool by_stress = false;  ///< compressed by loads along the axis and across it: the ratio is what was asked for
  std::vector<double> strain;           ///< positive where a side shortens; how large it is where the sample is sheared
  std::vector<double> ratio;            ///< NaN where the sides are all but unloaded
  std::vector<double> shear, normal;    ///< what it is the ratio of, Pa; empty of a stress
  std::vector<double> volume;           ///< volumetric strain, compaction positive
  std::vector<double> solid_fraction;   ///< of the whole box
  std::vector<double> inertial_number;  ///< empty where it is not known

  std::string ratio_name() const { return sheared ? "mu" : confined ? "q_over_p" : "axial_stress"; }
  const char* ratio_unit() const { return sheared || confined ? "" : "Pa"; }
};

inline constexpr double strain_of_a_test = 2e-3;  ///< less is none

/// From the forces on the sides and their places. Nothing for a stage that strains by less than 0.2 %, on which nothing
/// presses, or that kept no history of its sides.
std::optional<TestCurves> test_curves(const Test& test);

/// Of what is known over a hundredth of the rows, fewer at the ends.
std::vector<double> running_mean(const std::vector<double>& values);
/// The ratio of such means of what it is the ratio of, as the critical state is told; of a stress its mean.
std::vector<double> running_ratio(const TestCurves& curves);

/// The critical state: the part of a test in which its ratio and the volume only fluctuate while the strain goes on.
struct CriticalState {
  double from = 0, to = 0;                       ///< strain
  double inertial_number = statistics::unknown;  ///< mean of its size
  statistics::Measured ratio,
      solid_fraction;  ///< the ratio of the means of shear and normal stress, not the mean of their ratio
  bool sure =
      true;  ///< both errors are of blocks that are independent; else one or both are the largest of few long blocks
};

/// Where the transients of both have ended (fields::find_steady_state). Nothing where the test was cyclic, where loads
/// alone compress the sample, where its strain all but stops, or where the ratio or the solid fraction drifts to the
/// end.
std::optional<CriticalState> critical_state(const TestCurves& curves);

/// The largest running ratio on the way to the critical state, where it is above all that this may be. Rows at the
/// ends, whose means are of few, do not count.
struct Peak {
  std::size_t row = 0;
  double ratio = 0;
};
std::optional<Peak> peak_of(const TestCurves& curves, const std::optional<CriticalState>& state);

/// As `arenite show` and the page have it: from, to, the inertial number, whether it is sure, and value, error, low_95,
/// high_95 of the ratio, by its name, and of the solid fraction.
Numbers numbers_of(const TestCurves& curves, const CriticalState& state);

}  // namespace arenite::fields
