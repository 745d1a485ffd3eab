#pragma once
#include <optional>
#include <string>

#include "model/lockin_maps.hpp"
#include "thermal/identify/curve.hpp"
#include "thermal/identify/findings.hpp"

namespace arenite::workflow {

struct FactorRequest {
  std::optional<double> section;                       ///< of the specimen, m^2, where the file gives forces
  std::optional<statistics::Measured> young, poisson;  ///< where it gives strains
  /// How the file gives temperatures and signals, and stresses, forces and strains.
  AmplitudeConvention temperature = AmplitudeConvention::peak_to_peak, load = AmplitudeConvention::peak_to_peak;
  bool through_origin = false;
  std::optional<identify::Detector> detector;  ///< for the constant of a raw signal
  std::string stated;
};

/// Thermoelastic factor A of every group (material) of a file, by what its columns allow: stress or force against
/// temperature, strain against temperature, or alpha, T_0, rho and c_p; the constant A' where a raw signal stands for
/// the temperature.
identify::Identification identify_factor(const std::string& file, const FactorRequest& request);

}  // namespace arenite::workflow
