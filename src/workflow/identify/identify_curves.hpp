#pragma once
#include <optional>
#include <string>
#include <utility>

#include "thermal/identify/curve.hpp"
#include "thermal/identify/findings.hpp"

namespace arenite::workflow {

struct StiffnessRequest {
  identify::StiffnessOptions curve;
  std::optional<double> length;  ///< of the cylinders, m; gives the stiffness of a unit of length too
  std::string stated;            ///< file of what a source states for the same groups; or empty
};

/// Contact stiffness of every group of a file. Records (columns displacement, force; perhaps a group and a test) are
/// cut into cycles; tables hold slopes already found, one a row (column stiffness) or a column a group. A group's error
/// is the scatter of its tests; of a single test, that of its slope. Throws InputError with file and line.
identify::Identification identify_stiffness(const std::string& file, const StiffnessRequest& request);

struct AdhesionRequest {
  std::optional<statistics::Measured> stiffness;   ///< of the pair, N/m
  std::optional<std::pair<double, double>> radii;  ///< of both cylinders, m
  identify::EffectiveRadius effective_radius = identify::EffectiveRadius::four_reduced;
  std::string stated;
};

/// Separation force and, where stiffness and radii are given, surface energy of every group of a file: pull-off records
/// (columns displacement or time, force) or tables of separation forces, one a row or a column a group.
identify::Identification identify_adhesion(const std::string& file, const AdhesionRequest& request);

}  // namespace arenite::workflow
