#pragma once
#include <cstdint>
#include <optional>

namespace arenite {

class ParameterVisitor;

/// How the grains and contacts of a state are measured.
struct Measuring {
  double border = 2.5;                   ///< strip left out along each wall, in mean diameters (T 3.2.4)
  std::optional<double> load_axis = {};  ///< direction of the load for signed anisotropies, rad from x; unset: that of
                                         ///< the sides that load, or of greatest compression of the sample's own stress
  std::uint64_t seed = 1;                ///< of the places of windows
  bool operator==(const Measuring&) const = default;
};

/// Every parameter: its name, unit, range and meaning, for recipes, commands and Python.
void declare(ParameterVisitor& visitor, Measuring& measuring);

}  // namespace arenite
