#pragma once
#include <vector>

#include "model/packing.hpp"

namespace arenite::inference {

/// A contact as one of its grains has it: `normal` points into the grain; the force on it is fn normal + ft t.
struct Touch {
  int contact = 0;
  int partner = -1;       ///< the other grain; -1: a wall
  Vec2 normal;
  double distance = 0;    ///< between the two centres, m; 0 at a wall
};

/// The contacts of every grain, with normals between the centres given (periodic images included); a wall's normal is
/// its own.
std::vector<std::vector<Touch>> touches_of_grains(const Packing& packing, const std::vector<Vec2>& centre);

}  // namespace arenite::inference
