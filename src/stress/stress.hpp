#pragma once
#include <string>
#include <vector>

#include "model/packing.hpp"
#include "model/phase_map.hpp"
#include "model/stress_field.hpp"

/// Statistics of node stresses by phase (P IV; science.md 5.3). The numbers' types and fits are those of grains and
/// contacts.
namespace arenite::stress {

struct StressOptions {
  int clamp_rows = 4;                ///< left out at the lower and the upper edge
  bool leave_out_surface = false;    ///< nodes with a neighbour (of eight) of another phase or grain
  bool operator==(const StressOptions&) const = default;
};

}  // namespace arenite::stress
