#pragma once
#include <optional>
#include <vector>

#include "model/lockin_maps.hpp"
#include "thermal/identify/curve.hpp"
#include "thermal/identify/findings.hpp"

/// What is found of a group of tests: constants with their names, units and equations.
namespace arenite::identify {

/// Contact stiffness k (T eq. 2.1), and where the cylinders' `length` (m) is known that of a unit of length, k/L.
std::vector<Finding> stiffness_findings(const statistics::Measured& k, std::optional<double> length);

/// What a separation force says of a pair of cylinders.
struct Pair {
  statistics::Measured stiffness;  ///< N/m
  double effective_radius = 0;     ///< r_eff, m
};

/// Separation force F_c; of a known pair the surface energy (T eq. 1.25), the force at which the law separates, its
/// overlap without force, and k/gamma.
std::vector<Finding> adhesion_findings(const statistics::Measured& separation_force, const std::optional<Pair>& pair);

/// k/gamma above which cohesion does not show in the mechanics of a packing (T 2.4.3).
inline constexpr double no_trace_of_cohesion = 50;

/// Causes and responses of one group of tests, peak to peak, as far as they were measured; empty where not.
struct CausesAndResponses {
  std::vector<double> stress;       ///< Pa
  std::vector<double> strain;       ///< eps_kk, the sum of both in-plane strains
  std::vector<double> temperature;  ///< K
  std::vector<double> signal;       ///< levels
};

/// A constant as the slope of a line through the tests of a group.
struct SlopeFound {
  Constant constant;
  Factor factor;
  bool of_temperature = true;  ///< or of a signal
};

/// Whether the line misses the origin beyond its error: a linear response has no intercept.
bool misses_origin(const Factor& factor);

/// Thermoelastic factors (T eqs. 1.55, 1.70) of the temperatures and constants of the signal (T eqs. 1.69, 1.71), each
/// from stresses and from strains as far as these are known; strains need `specimen`. Values that are not positive are
/// no answers: the tests do not tell them.
std::vector<SlopeFound> factors_of(const CausesAndResponses& tests, const std::optional<Elastic>& specimen,
                                   bool through_origin);

/// The intercept of a line as a finding beside its slope; nothing of a line that was held to the origin.
std::optional<Finding> intercept_of(const SlopeFound& slope);

/// A factor that follows from properties (T eq. 1.55).
Finding factor_finding(const statistics::Measured& factor);

/// Constants of a signal without a test (T eq. 1.68), as printed and with the detector's band, and the band's exponent.
std::vector<Finding> direct_findings(const Detector& detector, const statistics::Measured& factor);

/// Peak-to-peak values of quantities that are given in this convention.
std::vector<double> peak_to_peak(std::vector<double> values, AmplitudeConvention given);

}  // namespace arenite::identify
