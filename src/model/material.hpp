#pragma once
#include <string>
#include <vector>

namespace arenite {

/// A constitutive material of grains; parameters that concern a pair follow from two of these (dem/laws).
struct Material {
  std::string name;
  double density = 0;               ///< kg/m^3
  double stiffness = 0;             ///< contact stiffness k, N/m (T ch. 2)
  double thermoelastic_factor = 0;  ///< A, K/Pa (T ch. 2); 0 if not known
  bool operator==(const Material&) const = default;
};

using Materials = std::vector<Material>;

}  // namespace arenite
