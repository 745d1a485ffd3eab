#pragma once
#include <cmath>

namespace arenite::geometry {

/// Area between an arc that turns by `angle` (rad, its sign is the area's) and its chord, radius^2 (angle - sin angle)/2,
/// without loss of digits where the arc is nearly straight.
inline double circular_segment_area(double radius, double angle) {
  const double square = angle * angle;
  const double difference =
      std::abs(angle) > 0.3
          ? angle - std::sin(angle)
          : angle * square / 6 *
                (1 - square / 20 * (1 - square / 42 * (1 - square / 72 * (1 - square / 110 * (1 - square / 156)))));
  return 0.5 * radius * radius * difference;
}

}  // namespace arenite::geometry
