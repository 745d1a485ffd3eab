#include "model/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/decimals.hpp"
#include "geometry/rim.hpp"

namespace arenite {

std::vector<geometry::Edge> rim_of(const Shape& shape) {
  return shape.filled ? geometry::rim_of_polygon(shape.place, shape.radius.front())
                      : geometry::rim_of_disks(shape.place, shape.radius);
}

Shape scaled_to(const Shape& shape, double radius) {
  const geometry::Moments m = geometry::moments_within(rim_of(shape));
  const double scale = radius * std::sqrt(std::numbers::pi / m.area);
  Shape scaled = shape;
  for (Vec2& p : scaled.place) p = scale * (p - m.centre);
  for (double& r : scaled.radius) r *= scale;
  return scaled;
}

double gyration_of(const Shape& shape) {
  const geometry::Moments m = geometry::moments_within(rim_of(shape));
  return std::sqrt(m.polar / m.area + dot(m.centre, m.centre));
}

double reach_of(const Shape& shape) {
  double reach = 0;
  for (std::size_t k = 0; k < shape.place.size(); ++k) reach = std::max(reach, norm(shape.place[k]) + shape.radius[k]);
  return reach;
}

Shape shape_of(const Grains& grains, std::size_t g) {
  const Shapes& all = grains.shapes;
  if (all.empty()) return {{{}}, {grains.radius[g]}, false};
  Shape shape;
  for (std::int32_t d = all.first[g]; d < all.first[g + 1]; ++d) {
    shape.place.push_back(all.place[d]);
    shape.radius.push_back(all.radius[d]);
  }
  shape.filled = all.filled[g] != 0;
  return shape;
}

void add_shape(Shapes& shapes, const Shape& shape, double gyration) {
  if (shapes.first.empty()) shapes.first.push_back(0);
  for (std::size_t k = 0; k < shape.place.size(); ++k) {
    shapes.place.push_back(shape.place[k]);
    shapes.radius.push_back(shape.radius[k]);
  }
  shapes.first.push_back(static_cast<std::int32_t>(shapes.place.size()));
  shapes.filled.push_back(shape.filled ? 1 : 0);
  shapes.gyration.push_back(gyration);
}

std::vector<Vec2> outline_of(const Grains& grains, std::size_t g, double step) {
  const Vec2 by = direction(grains.angle[g]), centre = grains.position[g];
  std::vector<Vec2> points;
  for (const geometry::Edge& edge : rim_of(shape_of(grains, g))) {
    const int parts = edge.straight() ? 1 : static_cast<int>(std::ceil(std::abs(edge.sweep) / step));
    for (int p = 0; p < parts; ++p) points.push_back(centre + turned(edge.at(static_cast<double>(p) / parts), by));
  }
  return points;
}

Vec2 direction(double angle) {
  // 1/(n (n + 1)) at n: products, which cost less than quotients.
  static constexpr std::array<double, 17> inverse_of_product = [] {
    std::array<double, 17> inverse{};
    for (int n = 1; n < 17; ++n) inverse[n] = 1.0 / (n * (n + 1));
    return inverse;
  }();
  // Quarter turns are taken off with pi/2 in two parts, the rest is at most pi/4, where the series end below the last
  // bit.
  constexpr double quarter = 1.5707963267948966, rest_of_quarter = 6.123233995736766e-17;
  const double quarters = std::nearbyint(angle / quarter);
  const double x = (angle - quarters * quarter) - quarters * rest_of_quarter, square = x * x;
  double sine = 0, cosine = 0;
  for (std::size_t n = 8; n >= 1; --n) {
    cosine = square * inverse_of_product[2 * n - 1] * (1 - cosine);
    sine = square * inverse_of_product[2 * n] * (1 - sine);
  }
  cosine = 1 - cosine;
  sine = x * (1 - sine);
  switch (static_cast<int>(std::fmod(quarters, 4.0)) & 3) {
    case 0: return {cosine, sine};
    case 1: return {-sine, cosine};
    case 2: return {-cosine, -sine};
    default: return {sine, -cosine};
  }
}

std::vector<Vec2> points_on_arc(Vec2 centre, double diameter, const Turn& turn, std::int64_t steps,
                                std::int64_t count) {
  const auto on_rim = [&](double middle, double off) {
    return in_decimals(middle + off, std::max(std::abs(middle), 0.5 * diameter));
  };
  std::vector<Vec2> points;
  for (std::int64_t k = 0; k < count; ++k) {
    const Vec2 radius =
        0.5 * diameter * direction(turn.from + turn.by * static_cast<double>(k) / static_cast<double>(steps));
    points.push_back({on_rim(centre.x, radius.x), on_rim(centre.y, radius.y)});
  }
  return points;
}

}  // namespace arenite
