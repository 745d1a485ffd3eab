#pragma once
#include "model/phase_map.hpp"

namespace arenite::test {

/// One phase everywhere; particle nodes all belong to one grain.
inline PhaseMap homogeneous_sample(int width, int height, Phase phase = Phase::matrix) {
  PhaseMap map = make_phase_map(width, height, 1e-3);
  map.phase.assign(map.size(), phase);
  map.grain_class = {GrainClass::none};
  if (phase == Phase::particle) map.grain.assign(map.size(), 0);
  return map;
}

}  // namespace arenite::test
