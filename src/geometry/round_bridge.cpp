#include "geometry/round_bridge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::geometry {
namespace {

using std::numbers::pi;

Vec2 on_i(const MeniscusDisks& d, double filling) { return d.radius_i * Vec2{std::cos(filling), std::sin(filling)}; }
Vec2 on_j(const MeniscusDisks& d, double filling) {
  return {d.distance - d.radius_j * std::cos(filling), d.radius_j * std::sin(filling)};
}

/// Height of the arc where it is nearest to the joining line, m.
double neck_of(const MeniscusShape& s) {
  const bool dips = s.radius > 0 && s.centre.x > s.touch_i.x && s.centre.x < s.touch_j.x;
  return dips ? s.centre.y - s.radius : std::min(s.touch_i.y, s.touch_j.y);
}

}  // namespace

std::optional<MeniscusShape> round_bridge(const MeniscusDisks& d, double contact_angle, double width) {
  if (d.distance <= std::abs(d.radius_i - d.radius_j) || !(width > 0)) return {};
  const double c = std::cos(contact_angle), s = std::sin(contact_angle);
  const double straight = std::acos((d.radius_i - d.radius_j) * c / d.distance) - contact_angle;
  const double filling = std::min(std::asin(std::min(width, 1.0)), straight);
  MeniscusShape shape{on_i(d, filling), {}, {}, 0, d.distance};
  // The arc's centre lies R along u from its end on sphere i, and as far from sphere j as it does from sphere i:
  // (end + R u - j)^2 = r_j^2 + R^2 + 2 r_j R cos(contact angle).
  const Vec2 u{std::cos(filling + contact_angle), std::sin(filling + contact_angle)};
  const Vec2 from_j = shape.touch_i - Vec2{d.distance, 0};
  const double outside = dot(from_j, from_j) - d.radius_j * d.radius_j, bend = 2 * (d.radius_j * c - dot(from_j, u));
  if (!(outside > 0)) return {};
  if (bend <= 1e-7 * outside / (d.radius_i + d.radius_j)) {  // straight, but for what rounding moves the circle
    shape.touch_j = on_j(d, pi - filling - 2 * contact_angle);
    return shape;
  }
  const double arc = outside / bend;
  shape.radius = arc;
  shape.centre = shape.touch_i + arc * u;
  shape.touch_j =
      on_j(d, std::atan2(shape.centre.y, d.distance - shape.centre.x) - std::atan2(arc * s, d.radius_j + arc * c));
  if (!(neck_of(shape) > 0)) return {};
  return shape;
}

}  // namespace arenite::geometry
