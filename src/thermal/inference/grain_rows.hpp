#pragma once
#include <vector>

#include "thermal/inference/footprint.hpp"
#include "thermal/inference/grain_pixels.hpp"

namespace arenite::inference {

/// A grain whose light may spill over, and the whole periodic cells between its centre and the image that is near, m.
struct Near {
  std::size_t grain;
  Vec2 cells;
};

/// Where grains are and what presses them, as far as known.
struct Placed {
  double length = 1;                        ///< m, out of plane
  std::vector<double> radius, factor;       ///< m; K/Pa, one a grain
  std::vector<Vec2> centre, found;          ///< m: as refined, as the pixels are told from
  std::vector<std::vector<Touch>> touches;  ///< with normals between refined centres
  std::vector<std::vector<Near>> near;
  std::vector<double> force;                ///< fn and ft of every contact, N
};

/// Equations of the pixels of one grain: warming = sum over its touches of (fn, ft) times `response` + what spills over
/// from other grains + slopes times changes of the grain's centre and of its normals' directions.
struct GrainRows {
  std::vector<double> response;   ///< K/N, pixels x (2 touches)
  std::vector<double> spill;      ///< K
  std::vector<double> shift;      ///< K/m, pixels x 2: the centre moves
  std::vector<double> turn;       ///< K/rad, pixels x touches: a normal turns counter-clockwise
};

GrainRows rows_of_grain(const Placed& placed, std::size_t grain, const std::vector<GrainPixel>& pixels, const Footprint& footprint);

}  // namespace arenite::inference
