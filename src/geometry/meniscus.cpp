#include "geometry/meniscus.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/outline.hpp"

namespace arenite::geometry {
namespace {

/// Angles at the two centres from the joining line to the points where the arc touches, rad.
struct MeniscusAngles {
  double i = 0, j = 0;
};

MeniscusAngles meniscus_angles(const MeniscusDisks& d, double curvature) {
  // Half angles of the triangle with sides r_i + R, r_j + R, distance; divided by R so that R may be infinite.
  const double difference = d.radius_i - d.radius_j, skew = (d.distance - difference) / (d.distance + difference);
  const double perimeter = 0.5 * (d.radius_i + d.radius_j + d.distance);
  const double ratio = std::isinf(curvature) ? -0.5 * d.gap() / perimeter
                                             : (1 - 0.5 * curvature * d.gap()) / (1 + curvature * perimeter);
  const double root = std::max(ratio, 0.0);
  return {2 * std::atan(std::sqrt(root * skew)), 2 * std::atan(std::sqrt(root / skew))};
}

/// Centre i is the origin and centre j lies on the x axis.
struct TouchPoints {
  Vec2 i, j;
};

TouchPoints touch_points(const MeniscusDisks& d, const MeniscusAngles& angle) {
  return {{d.radius_i * std::cos(angle.i), d.radius_i * std::sin(angle.i)},
          {d.distance - d.radius_j * std::cos(angle.j), d.radius_j * std::sin(angle.j)}};
}

/// Area common to two overlapping disks.
double lens_area(const MeniscusDisks& d) {
  if (d.gap() >= 0) return 0;
  const MeniscusAngles half = meniscus_angles(d, std::numeric_limits<double>::infinity());
  return circular_segment_area(d.radius_i, 2 * half.i) + circular_segment_area(d.radius_j, 2 * half.j);
}

/// Half the width of the bridge where it is narrowest, m; not positive: the two arcs meet and there is no bridge.
double meniscus_neck(const MeniscusDisks& d, double curvature) {
  if (std::isinf(curvature)) return d.gap() < 0 ? d.radius_i * std::sin(meniscus_angles(d, curvature).i) : 0;
  const MeniscusAngles angle = meniscus_angles(d, curvature);
  const TouchPoints touch = touch_points(d, angle);
  // The arc dips below its ends only if its lowest point, right below the circle's centre, lies between them.
  if (std::cos(angle.i) <= 0 || std::cos(angle.j) <= 0 || curvature == 0) return std::min(touch.i.y, touch.j.y);
  // Height of the circle's centre less its radius: r_i sin a - R (1 - sin a).
  const double s = std::sin(angle.i), c = std::cos(angle.i);
  return d.radius_i * s - c * c / (1 + s) / curvature;
}

}  // namespace

double meniscus_area(const MeniscusDisks& d, double curvature) {
  if (std::isinf(curvature)) return 0;
  const MeniscusAngles angle = meniscus_angles(d, curvature);
  const TouchPoints t = touch_points(d, angle);
  const Vec2 j{d.distance, 0};
  const double quadrilateral = 0.5 * (cross(j, t.j) + cross(t.j, t.i));
  const double sectors = 0.5 * (d.radius_i * d.radius_i * angle.i + d.radius_j * d.radius_j * angle.j);
  double hollow = 0;
  if (curvature > 0) {
    const double chord = norm(t.j - t.i), turn = 2 * std::asin(std::min(1.0, 0.5 * chord * curvature));
    hollow = circular_segment_area(1 / curvature, turn);
  }
  return 2 * (quadrilateral - sectors - hollow) + lens_area(d);
}

double largest_meniscus_curvature(const MeniscusDisks& d) {
  if (d.gap() <= 0) return std::numeric_limits<double>::infinity();
  // The arcs meet on the joining line at x: then x^2 - r_i^2 = 2 r_i R and likewise from j, a quadratic in x.
  const double ri = d.radius_i, rj = d.radius_j;
  const double b = d.distance * ri, c = -ri * (d.distance * d.distance + ri * rj - rj * rj);
  const double x = -c / (b + std::sqrt(b * b - (rj - ri) * c));
  return 2 * ri / ((x - ri) * (x + ri));
}

bool MeniscusShape::contains(Vec2 p) const {
  const Vec2 j{length, 0};
  if (cross(touch_j - j, p - j) < 0 || cross(touch_i - touch_j, p - touch_j) < 0 || cross(-touch_i, p - touch_i) < 0)
    return false;
  return radius == 0 || dot(p - centre, p - centre) >= radius * radius;
}

std::optional<MeniscusShape> meniscus_shape(const MeniscusDisks& d, double radius) {
  if (d.distance <= std::abs(d.radius_i - d.radius_j)) return {};
  // Beyond this an arc differs from its chord by less than rounding moves the circle.
  const bool straight = radius > 1e7 * (d.radius_i + d.radius_j);
  const double curvature = straight ? 0 : 1 / radius;
  if (meniscus_neck(d, curvature) <= 0) return {};
  const MeniscusAngles angle = meniscus_angles(d, curvature);
  const TouchPoints touch = touch_points(d, angle);
  MeniscusShape shape{touch.i, touch.j, {}, 0, d.distance};
  if (straight) return shape;
  shape.radius = radius;
  shape.centre = ((d.radius_i + radius) / d.radius_i) * touch.i;
  return shape;
}

}  // namespace arenite::geometry
