#include "thermal/identify/constants.hpp"

#include <cmath>

#include "model/lockin_maps.hpp"

namespace arenite::identify {
namespace {

using statistics::Measured;

const Constant stiffness{"stiffness", "kN/mm", "k, force over displacement, T eq. 2.1"},
    stiffness_per_length{"stiffness_per_length", "MPa", "k over the length of the cylinders"};

const Constant separation{"separation_force", "N", "F_c, the largest tension that the glue holds"},
    energy{"surface_energy", "kN/mm", "gamma = sqrt(4 k F_c/r_eff), T eq. 1.25"},
    threshold_force{"threshold_force", "N", "r_eff gamma^2/(4 k), the tension at which the law separates"},
    overlap_without_force{"overlap_without_force", "um", "r_eff gamma^2/k^2, where attraction and repulsion balance"},
    stiffness_over_surface_energy{"stiffness_over_surface_energy", "",
                                  "k/gamma; above 50 cohesion has no effect on the mechanics, T 2.4.3"};

const Constant factor{"factor", "K/MPa", "A of dT = -A d(sigma_kk), T eq. 1.55"},
    from_strain{"factor_from_strain", "K/MPa", "A from the stresses that follow from strains, T eq. 1.70"},
    of_signal{"signal_constant", "MPa", "A' of sigma_kk = A' S, the stress of one level of signal, T eq. 1.69"},
    of_signal_from_strain{"signal_constant_from_strain", "MPa",
                          "A' from the stresses that follow from strains, T eq. 1.71"},
    direct{"signal_constant_direct", "MPa", "A' = D R F/(T eps A) with R of a detector of all wavelengths, T eq. 1.68"},
    direct_in_band{"signal_constant_direct_in_band", "MPa", "The same with R of the band"},
    exponent{"exitance_exponent", "", "n of the photons N ~ T^n in the band"};

}  // namespace

std::vector<Finding> stiffness_findings(const Measured& k, std::optional<double> length) {
  std::vector<Finding> findings{{stiffness, k}};
  if (length) findings.push_back({stiffness_per_length, statistics::product({{k, 1}, {{*length}, -1}})});
  return findings;
}

std::vector<Finding> adhesion_findings(const Measured& force, const std::optional<Pair>& pair) {
  std::vector<Finding> findings{{separation, force}};
  if (!pair) return findings;
  const auto& [k, radius] = *pair;
  const Measured gamma = surface_energy(force, k, radius);
  const auto at = threshold(gamma.value, k.value, radius);
  findings.push_back({energy, gamma});
  findings.push_back({threshold_force, {at.force, force.error, force.freedom}});
  findings.push_back({overlap_without_force, {at.free_overlap}});
  findings.push_back({stiffness_over_surface_energy, {k.value / gamma.value}});
  return findings;
}

bool misses_origin(const Factor& f) {
  const auto& intercept = f.line.intercept;
  if (!std::isfinite(intercept.error)) return false;
  const auto range = statistics::confidence_95(intercept);
  return range.low > 0 || range.high < 0;
}

std::vector<SlopeFound> factors_of(const CausesAndResponses& tests, const std::optional<Elastic>& specimen,
                                   bool through_origin) {
  const auto& [stress, strain, temperature, signal] = tests;
  std::vector<SlopeFound> found;
  if (!temperature.empty()) {
    if (!stress.empty()) found.push_back({factor, factor_from_stress(stress, temperature, through_origin)});
    if (!strain.empty())
      found.push_back({stress.empty() ? factor : from_strain,
                       identify::factor_from_strain(strain, temperature, *specimen, through_origin)});
  }
  if (!signal.empty()) {
    if (!stress.empty()) found.push_back({of_signal, signal_constant(stress, signal, through_origin), false});
    if (!strain.empty()) {
      Factor f = signal_constant(strain, signal, through_origin);
      f.factor = statistics::product({{f.factor, 1}, {stress_over_strain(*specimen), 1}});
      found.push_back({stress.empty() ? of_signal : of_signal_from_strain, f, false});
    }
  }
  return found;
}

std::optional<Finding> intercept_of(const SlopeFound& slope) {
  const auto& intercept = slope.factor.line.intercept;
  if (!std::isfinite(intercept.error)) return std::nullopt;
  return Finding{{slope.constant.name + "_intercept", slope.of_temperature ? "K" : "",
                  "Intercept of the line at zero load; 0 for a linear response"},
                 intercept};
}

Finding factor_finding(const Measured& value) { return {factor, value}; }

std::vector<Finding> direct_findings(const Detector& d, const Measured& value) {
  return {{direct, direct_constant(d, printed_correction(d), value)},
          {direct_in_band, direct_constant(d, band_correction(d), value)},
          {exponent, {radiometry::exitance_exponent(d.band, d.surface)}}};
}

std::vector<double> peak_to_peak(std::vector<double> values, AmplitudeConvention given) {
  for (double& v : values) v *= to_peak_to_peak(given);
  return values;
}

}  // namespace arenite::identify
