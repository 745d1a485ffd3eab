#pragma once
#include <vector>

#include "core/vec2.hpp"

namespace arenite::inference {

/// What a pixel sees of the plane: the mean over its square of a picture that a lens has blurred with a Gaussian, as a
/// sum over points beside its centre. Weights add up to 1; `slope` is the weight's gradient with respect to the place
/// of the point (seen from the pixel), 1/m. Harmonic fields are seen as in the centre, whatever the blur.
struct Footprint {
  struct Point {
    Vec2 place;      ///< m from the pixel's centre
    double weight;
    Vec2 slope;
  };
  std::vector<Point> points;
  double reach = 0;  ///< no point lies farther, m

  /// Standard deviation of the blur in pixels; points lie a quarter of a pixel apart.
  Footprint(double pixel, double blur);
};

}  // namespace arenite::inference
