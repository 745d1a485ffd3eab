#pragma once
#include <optional>

#include "model/result.hpp"
#include "statistics/measured.hpp"

namespace arenite::fields {

/// A filling between two walls on a floor, means over the second half of a stage.
struct SiloState {
  double height = 0;                           ///< mean height of the filling, m
  double width = 0, thickness = 0;             ///< of the box, m
  statistics::Measured force;                  ///< on the floor, N
  double weight = 0;                           ///< of the grains under the gravity that acted, N
  double wall_friction = statistics::unknown;  ///< weight that the walls carry over their normal force
  double stress_ratio = statistics::unknown;   ///< <sigma_xx>/<sigma_yy> of the contacts of its states
  double area() const { return width * thickness; }
};

/// Nothing where gravity does not pull straight down, there are no states, floor or walls are missing or bear nothing.
std::optional<SiloState> silo_state(const StageResult& stage);

}  // namespace arenite::fields
