#pragma once
#include <vector>

#include "grains/packing/grain_shapes.hpp"
#include "model/shapes.hpp"
#include "support.hpp"

/// Grains that are no disks.
namespace arenite::verification {

/// A rounded polygon with the area of a disk of `radius`.
struct Polygon {
  std::int64_t corners = 4;
  Vec2 centre;
  double angle = 0;
  Vec2 velocity = {};
  double spin = 0, radius = 6.2e-3, aspect = 1, rounding = 0.1;
};

inline void add(Packing& p, const Polygon& polygon) {
  const Shape shape =
      scaled_to(packing::PolygonShape{polygon.corners, polygon.aspect, polygon.rounding}.make(), polygon.radius);
  add_shape(p.grains.shapes, shape, gyration_of(shape));
  add(p, Disk{polygon.centre, polygon.radius, pom, polygon.velocity, polygon.spin});
  p.grains.angle.back() = polygon.angle;
}

inline double half_side(const Packing& p, std::size_t g) {
  return p.grains.shapes.place[static_cast<std::size_t>(p.grains.shapes.first[g])].x;
}
inline double rounding(const Packing& p, std::size_t g) {
  return p.grains.shapes.radius[static_cast<std::size_t>(p.grains.shapes.first[g])];
}

/// A grain of equal disks whose centres lie at these places, about its centre of mass, with the area of a disk of
/// `radius`.
struct Clump {
  std::vector<Vec2> places;
  Vec2 centre;
  double radius = 6.2e-3, angle = 0;
  Vec2 velocity = {};
  double spin = 0;
};

inline void add(Packing& p, const Clump& clump) {
  Shape shape{clump.places, std::vector<double>(clump.places.size(), 1.0), false};
  shape = scaled_to(shape, clump.radius);
  add_shape(p.grains.shapes, shape, gyration_of(shape));
  add(p, Disk{clump.centre, clump.radius, pom, clump.velocity, clump.spin});
  p.grains.angle.back() = clump.angle;
}

inline const std::vector<Vec2> dumbbell{{-0.8, 0}, {0.8, 0}}, bent{{-1, 0}, {0.2, 0.1}, {0.9, 1.1}};

/// What all grains have together, about the origin.
struct MotionOfAll {
  Vec2 momentum;
  double angular = 0, kinetic = 0;
};
inline MotionOfAll motion_of(const Packing& p) {
  MotionOfAll sum;
  const Grains& g = p.grains;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double m = mass(p, k), inertia = m * g.shapes.gyration[k] * g.shapes.gyration[k];
    const Vec2 v = g.velocity[k];
    sum.momentum += m * v;
    sum.angular += m * cross(g.position[k], v) + inertia * g.omega[k];
    sum.kinetic += 0.5 * m * dot(v, v) + 0.5 * inertia * g.omega[k] * g.omega[k];
  }
  return sum;
}

/// side x side grains pressed together until every one touches several others.
inline Packing pressed_together(const Packing& crowd, int side) {
  dem::ContactParameters smooth;
  smooth.friction = 0;
  smooth.restitution = 0.3;
  dem::Engine engine(crowd, smooth, {});
  const double speed = side > 6 ? 100 : 2;
  set_drives(engine, {moved(speed), moved(-speed), moved(speed), moved(-speed)});
  while (packing_of(engine).contacts.size() < static_cast<std::size_t>((side > 6 ? 1 : 2.5) * side * side))
    engine.advance(50);
  return packing_of(engine);
}

/// Of a crowd of 36 between walls or in a periodic cell, pressed by them or sheared with it.
inline void expect_energy_is_closed(Packing (*pressed)(bool periodic, int side)) {
  for (const int boundary : {0, 1, 2}) {  // walls, periodic, periodic and sheared
    dem::ContactParameters law;
    law.friction = 0.4;
    law.restitution = 0.4;
    dem::IntegrationParameters how;
    how.safety = 1.0 / 500;
    how.track_energy = true;
    dem::Engine engine(pressed(boundary > 0, 6), law, how);
    set_drives(engine, {moved(0.8), moved(-0.8), moved(0.8), moved(-0.8)});
    if (boundary == 2) set_shear_rate(engine, 30);
    const Energies before = energies_of(engine);
    engine.advance(15'000);
    const Energies after = energies_of(engine);
    const double stored = after.kinetic + after.elastic - before.kinetic - before.elastic,
                 work = after.work_walls - before.work_walls;
    const double lost = after.dissipated_normal + after.dissipated_friction + after.dissipated_drag;
    EXPECT_GT(after.dissipated_friction, 0);
    EXPECT_GT(after.elastic, 5 * before.elastic);
    EXPECT_NEAR((stored + lost - work) / work, 0, 1e-6)
        << boundary << " work " << work << " lost " << lost << " stored " << stored;
  }
}

/// Of a crowd that is large enough for two threads.
inline void expect_same_bits(const Packing& crowd) {
  std::uint64_t hash = 0;
  for (const char* kernel : {"portable", "auto"})
    for (const int threads : {1, 2}) {
      dem::IntegrationParameters how;
      how.threads = threads;
      how.kernel = kernel;
      dem::Engine engine(crowd, {}, how);
      set_drives(engine, {moved(5), moved(-5), moved(5), moved(-5)});
      engine.advance(300);
      if (hash == 0) hash = state_hash(engine);
      EXPECT_EQ(state_hash(engine), hash) << kernel << " " << threads;
      EXPECT_GT(packing_of(engine).contacts.size(), 1000U);
    }
}

}  // namespace arenite::verification
