#pragma once
#include <cstdint>

namespace arenite {

/// Two grains i < j that a liquid bridge joins, or that attract each other by adhesion, touching or not.
struct CohesivePair {
  std::int32_t i = 0, j = 0;
  double gap = 0;     ///< between the surfaces, m; negative where they overlap. The force of such a contact has the pull in it
  double pull = 0;    ///< along the line that joins them, N
  double energy = 0;  ///< J, 0 where it begins to act
};

}  // namespace arenite
