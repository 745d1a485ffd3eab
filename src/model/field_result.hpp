#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/cement.hpp"
#include "model/packing.hpp"
#include "model/phase_map.hpp"
#include "model/result.hpp"
#include "model/stress_field.hpp"
#include "statistics/numbers.hpp"

namespace arenite {

/// A bond that broke while a sample was pulled apart.
struct Crack {
  float x = 0, y = 0;            ///< middle of the bond, m
  std::uint8_t type = 0;         ///< 1 matrix, 2 interface, 3 particle
  double strain = 0;             ///< of the sample when it broke
};

/// The result of a stage on a raster: a cemented sample, or its stresses under load. One file in the store.
struct FieldResult {
  Provenance provenance;
  std::string name;              ///< stage's name in the recipe
  bool converged = true;
  std::string outcome;           ///< one sentence
  Packing packing;               ///< what was rasterised, in the map's coordinates; no grains if the map came from an image
  Cement cement;                 ///< of that packing
  PhaseMap map;
  StressField field;             ///< empty (size 0) if nothing was loaded; for a pull to failure that at the largest stress
  History convergence;           ///< columns "iteration", "residual"
  History curve;                 ///< of a pull to failure: "strain", "stress", "work", "elastic", "released", "broken"
  std::vector<Crack> cracks;     ///< in the order of breaking
  Numbers numbers;           ///< report and statistics as `show --json` gives them
};

}  // namespace arenite
