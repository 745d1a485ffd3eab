#pragma once
#include <optional>
#include <string>
#include <utility>

#include "thermal/identify/adhesion.hpp"
#include "thermal/identify/factor.hpp"
#include "thermal/identify/findings.hpp"
#include "thermal/identify/stiffness.hpp"

namespace arenite::study {

struct StiffnessRequest {
  identify::StiffnessOptions curve;
  std::optional<double> length;      ///< of the cylinders, m; gives the stiffness of a unit of length too
  std::string stated;                ///< file of what a source states for the same groups; or empty
};

/// Contact stiffness of every group of a file. Records (columns displacement, force; perhaps a group and a test) are cut into
/// cycles; tables hold slopes already found, one a row (column stiffness) or a column a group. A group's error is the
/// scatter of its tests; of a single test, that of its slope. Throws InputError with file and line.
identify::Identification identify_stiffness(const std::string& file, const StiffnessRequest& request);

struct AdhesionRequest {
  std::optional<statistics::Measured> stiffness;             ///< of the pair, N/m
  std::optional<std::pair<double, double>> radii;            ///< of both cylinders, m
  identify::EffectiveRadius effective_radius = identify::EffectiveRadius::four_reduced;
  std::string stated;
};

/// Separation force and, where stiffness and radii are given, surface energy of every group of a file: pull-off records
/// (columns displacement or time, force) or tables of separation forces, one a row or a column a group.
identify::Identification identify_adhesion(const std::string& file, const AdhesionRequest& request);

enum class Swing { full, half };

struct FactorRequest {
  std::optional<double> section;                             ///< of the specimen, m^2, where the file gives forces
  std::optional<statistics::Measured> young, poisson;        ///< where it gives strains
  Swing temperature_swing = Swing::full, stress_swing = Swing::full;
  bool through_origin = false;
  std::optional<identify::Detector> detector;                ///< for the constant of a raw signal
  std::string stated;
};

/// Thermoelastic factor A of every group (material) of a file, by what its columns allow: stress or force against temperature,
/// strain against temperature, or alpha, T_0, rho and c_p; the constant A' where a raw signal stands for the temperature.
identify::Identification identify_factor(const std::string& file, const FactorRequest& request);

}  // namespace arenite::study
