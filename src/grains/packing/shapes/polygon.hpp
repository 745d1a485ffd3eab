#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/parameters.hpp"
#include "model/shapes.hpp"

namespace arenite::packing {

/// A regular polygon, perhaps stretched, with rounded corners.
struct PolygonShape {
  std::int64_t corners = 4;
  double aspect = 1;      ///< stretch along one axis
  double rounding = 0.1;  ///< radius of the corners over that of the disk of the grain's area

  static constexpr Word word{"polygon", "a regular convex polygon with rounded corners"};
  void declare(ParameterVisitor& visitor) {
    visitor.integer({"corners", "How many corners a polygon has."}, corners, {3, 64});
    visitor.number({"aspect", "Stretch along one of its axes; 1: regular."}, aspect, "", range::between(1, 20));
    visitor.number({"rounding", "Radius of the corners over the radius of the disk of a grain's area; small ones need stiff contacts."}, rounding, "",
                   range::between(0.01, 0.5));
  }
  bool operator==(const PolygonShape&) const = default;

  /// With the area of a disk of radius 1: A s^2 + P s r + pi r^2 = pi for the polygon's own area A and length P.
  Shape make() const {
    Shape shape;
    shape.filled = true;
    const auto n = static_cast<std::size_t>(corners);
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 at = direction(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
      shape.place.push_back({aspect * at.x, at.y});
    }
    double area = 0, length = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 from = shape.place[k], to = shape.place[(k + 1) % n];
      area += 0.5 * cross(from, to);
      length += norm(to - from);
    }
    const double half = 0.5 * length * rounding, rest = std::numbers::pi * (1 - rounding * rounding);
    const double scale = (std::sqrt(half * half + area * rest) - half) / area;
    for (Vec2& p : shape.place) p = scale * p;
    shape.radius.assign(n, rounding);
    return shape;
  }
};

}  // namespace arenite::packing
