#include "geometry/ball_window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// Parts of a unit ball beyond planes at right angles follow from their surface by the theorem of the divergence: three
// volumes are the area on the sphere less each plane's distance times its face. That area is 2 pi less what its outline
// turns by (Gauss and Bonnet): a circle at distance a turns by a for every radian, and where two meet, by the angle
// between them.
namespace arenite::geometry {
namespace {

using std::numbers::pi;

/// Half the chord that planes at distances a and b have in common; rounding may take one that just touches beyond it.
double chord(double a, double b) { return std::sqrt(std::max(1 - a * a - b * b, 0.0)); }
/// Angle between the circles of these planes where they meet.
double turn(double a, double b) { return std::atan2(chord(a, b), -a * b); }

/// x >= a.
double cap(double a) { return pi * (1 - a) * (1 - a) * (2 + a) / 3; }

/// x >= a and y >= b.
double wedge(double a, double b) {
  if (a < 0) return cap(b) - wedge(-a, b);
  if (b < 0) return cap(a) - wedge(a, -b);
  if (a * a + b * b >= 1) return 0;
  const double half = chord(a, b), of_a = std::atan2(half, b), of_b = std::atan2(half, a);
  const double area = 2 * (std::atan2(half, a * b) - a * of_a - b * of_b);
  const double face_a = (1 - a * a) * of_a - b * half, face_b = (1 - b * b) * of_b - a * half;
  return (area - a * face_a - b * face_b) / 3;
}

/// x >= a, y >= b and z >= c.
double corner(double a, double b, double c) {
  if (a < 0) return wedge(b, c) - corner(-a, b, c);
  if (b < 0) return wedge(a, c) - corner(a, -b, c);
  if (c < 0) return wedge(a, b) - corner(a, b, -c);
  if (a * a + b * b + c * c >= 1) return 0;
  double area = 2 * pi - turn(a, b) - turn(b, c) - turn(c, a), faces = 0;
  for (const auto& [own, one, other] : {std::array{a, b, c}, {b, c, a}, {c, a, b}}) {
    const double along = chord(own, one), across = chord(own, other);
    const double arc = std::atan2(along, one) - std::atan2(other, across);
    area -= own * arc;
    faces += own * ((1 - own * own) * arc - one * (along - other) - other * (across - one)) / 2;
  }
  return (area - faces) / 3;
}

}  // namespace

double ball_window_volume(Vec3 centre, double radius, const Box<3>& window) {
  struct Side {
    int axis;
    double distance;  ///< of the window's side off the centre, in radii
  };
  std::array<Side, 6> cut{};
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double inside :
         {centre[axis] - window.corner[axis], window.corner[axis] + window.size[axis] - centre[axis]}) {
      if (inside <= -radius) return 0;
      if (inside < radius) cut[count++] = {axis, inside / radius};
    }
  // What lies beyond one side, less what lies beyond two, and so on.
  double missing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = cut[i].distance;
    missing += cap(a);
    for (std::size_t j = i + 1; j < count; ++j) {
      if (cut[j].axis == cut[i].axis) continue;
      const double b = cut[j].distance;
      missing -= wedge(a, b);
      for (std::size_t k = j + 1; k < count; ++k)
        if (cut[k].axis != cut[j].axis) missing += corner(a, b, cut[k].distance);
    }
  }
  return radius * radius * radius * (4 * pi / 3 - missing);
}

}  // namespace arenite::geometry
