#pragma once
#include <cmath>
#include <numbers>

#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {

inline constexpr double g = 9.81, r = 0.01;

inline Boundary polyline(std::vector<Vec2> points, bool closed = false) {
  Boundary boundary;
  boundary.name = "plate";
  boundary.centre = mean_point(points);
  boundary.points = std::move(points);
  boundary.closed = closed;
  return boundary;
}

inline Packing container_with(Boundary boundary) {
  Packing p = testing::empty_container(2, 2);
  p.domain.boundaries.push_back(std::move(boundary));
  return p;
}

inline ContactParameters with_friction(double mu, double restitution = 0.5) {
  ContactParameters contact;
  contact.friction = mu;
  contact.restitution = restitution;
  return contact;
}

/// Overlap under which a wall carries a force.
inline double overlap_under(double force) { return force / 27.35e6; }

inline double mass_of(double radius) { return 1410 * std::numbers::pi * radius * radius * 0.06; }

/// A crowd in a turning drum within the container.
inline Packing crowded_drum() {
  Packing p = testing::crowd(30, 30, 3, 0.0165);
  const Vec2 middle{0.5 * p.domain.width(), 0.5 * p.domain.height()};
  std::vector<Vec2> points;
  for (int k = 0; k < 24; ++k)
    points.push_back(middle + 0.18 * Vec2{std::cos(k * std::numbers::pi / 12), std::sin(k * std::numbers::pi / 12)});
  Packing inside = p;
  inside.grains = {};
  for (std::size_t k = 0; k < p.grains.size(); ++k)
    if (norm(p.grains.position[k] - middle) < 0.168)
      testing::add_grain(inside, p.grains.position[k].x, p.grains.position[k].y, p.grains.radius[k],
                         p.grains.material[k]);
  inside.domain.boundaries.push_back(polyline(points, true));
  return inside;
}

}  // namespace arenite::dem
