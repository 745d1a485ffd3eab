#pragma once
#include <numbers>
#include <utility>
#include <vector>

#include "grains/dem/engine.hpp"

// Spheres in a box with faces.
namespace arenite::dem::testing {

inline constexpr double gravity = 9.81, ball = 0.01, stiff = 1e6, density = 1410;
inline constexpr double mass = density * 4.0 / 3.0 * std::numbers::pi * ball * ball * ball, weight = mass * gravity;

inline BoundaryIn<3> faces(const std::vector<std::vector<Vec3>>& all) {
  BoundaryIn<3> boundary;
  boundary.name = "plate";
  for (const auto& face : all) {
    boundary.points.insert(boundary.points.end(), face.begin(), face.end());
    boundary.corners.push_back(static_cast<std::int32_t>(face.size()));
  }
  boundary.centre = mean_point(boundary.points);
  return boundary;
}

inline PackingIn<3> box_with(BoundaryIn<3> boundary, double size = 0.5) {
  PackingIn<3> p;
  p.materials = {{"pom", density, stiff, 0}};
  for (const int side : {right, top, front}) p.domain.wall[side].position = size;
  p.domain.boundaries.push_back(std::move(boundary));
  return p;
}

inline void add_ball(PackingIn<3>& p, Vec3 place, Vec3 velocity = {}) {
  p.grains.resize(p.grains.size() + 1);
  p.grains.position.back() = place;
  p.grains.velocity.back() = velocity;
  p.grains.radius.back() = ball;
}

inline ContactParameters rubbing(double mu, double restitution = 0.5) {
  ContactParameters contact;
  contact.friction = mu;
  contact.restitution = restitution;
  return contact;
}

inline void run_until(EngineIn<3>& engine, double time) {
  while (time_of(engine) < time) engine.advance(50);
}

}  // namespace arenite::dem::testing
