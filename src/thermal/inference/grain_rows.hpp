#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "statistics/least_squares.hpp"
#include "thermal/inference/balance.hpp"

namespace arenite::inference {

inline double squared(double x) { return x * x; }

/// What a pixel sees of the plane: the mean over its square of a picture that a lens has blurred with a Gaussian, as a
/// sum over points beside its centre. Weights add up to 1; `slope` is the weight's gradient with respect to the place
/// of the point (seen from the pixel), 1/m. Harmonic fields are seen as in the centre, whatever the blur.
struct PointSpread {
  struct Point {
    Vec2 place;  ///< m from the pixel's centre
    double weight;
    Vec2 slope;
  };
  std::vector<Point> points;
  double reach = 0;  ///< no point lies farther, m

  /// Standard deviation of the blur in pixels; points lie a quarter of a pixel apart.
  PointSpread(double pixel, double blur);
};

/// A pixel that belongs to a grain.
struct GrainPixel {
  Vec2 place;          ///< centre of the pixel, m, seen from the grain's centre as it was found
  float value, error;  ///< K
  double to_contact;   ///< distance from the nearest contact point, m
  std::size_t number;  ///< in the picture
};

using Pixels = std::vector<std::vector<GrainPixel>>;  ///< of every grain

/// A grain whose light may spill over, and the whole periodic cells between its centre and the image that is near, m.
struct Near {
  std::size_t grain;
  Vec2 cells;
};

/// Where grains are and what presses them, as far as known.
struct Placed {
  double length = 1;                   ///< m, out of plane
  std::vector<double> radius, factor;  ///< m; K/Pa, one a grain
  std::vector<std::int32_t> material;  ///< likewise
  std::vector<Vec2> centre, found;     ///< m: as refined, from which pixels are counted
  Touches touches;                     ///< with normals between refined centres
  std::vector<std::vector<Near>> near;
  std::vector<double> force;  ///< fn and ft of every contact, N
};

/// Equations of the pixels of one grain: warming = sum over its touches of (fn, ft) times `response` + what spills over
/// from other grains + slopes times changes of the grain's centre and of its normals' directions.
struct GrainRows {
  statistics::Matrix response;  ///< K/N, (2 touches) x pixels
  std::vector<double> spill;    ///< K
  std::vector<Vec2> shift;      ///< K/m: the centre moves
  statistics::Matrix turn;      ///< K/rad, touches x pixels: a normal turns counter-clockwise
};

GrainRows rows_of_grain(const Placed& placed, std::size_t grain, const std::vector<GrainPixel>& pixels,
                        const PointSpread& spread);

/// Warming that the pixels of one grain see under the present forces, K.
std::vector<double> warming_of_grain(const Placed& placed, std::size_t grain, const std::vector<GrainPixel>& pixels,
                                     const PointSpread& spread);

}  // namespace arenite::inference
