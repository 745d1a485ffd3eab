#include "samples.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "geometry/ball.hpp"
#include "grains/packing/grain_shapes.hpp"
#include "model/shapes.hpp"

namespace arenite::bench {

namespace {

constexpr double stiffness = 1e7;         // N/m
constexpr double target_pressure = 1e-3;  // P L/k

/// Radii (of disks of the same area) from and to, m, and the solid fraction to begin with.
struct Sizes {
  double from = 4e-3, to = 8e-3, solid_fraction = 0.6;
};

/// Grains on a jittered square or cubic lattice in mixed order.
template <int D> PackingIn<D> loose(std::size_t n, bool periodic, const Sizes& sizes = {}) {
  PackingIn<D> p;
  p.materials = {{"grain", 1000.0, stiffness, 0.0}};
  std::size_t side = 1, sites = 1;
  for (; sites < n; ++side) sites = static_cast<std::size_t>(std::pow(side + 1, D));
  p.grains.resize(n);
  RandomStream size(1, Purpose::radius), place(1, Purpose::position), order(1, Purpose::order);
  double content = 0;
  for (auto& r : p.grains.radius) {
    r = size.uniform(sizes.from, sizes.to);
    content += geometry::volume_of_ball<D>(r);
  }
  const double width = geometry::side_of_cube<D>(content / sizes.solid_fraction),
               pitch = width / static_cast<double>(side);
  std::vector<std::size_t> site(sites);
  for (std::size_t k = 0; k < sites; ++k) site[k] = k;
  for (std::size_t k = sites - 1; k > 0; --k) std::swap(site[k], site[order.below(k + 1)]);
  for (std::size_t k = 0; k < n; ++k)
    p.grains.position[k] = by_axis<D>([&, at = site[k]](int) mutable {
      const std::size_t line = at % side;
      at /= side;
      return (static_cast<double>(line) + place.uniform(0.45, 0.55)) * pitch;
    });
  for (int axis = 0; axis < D; ++axis) {
    p.domain.wall[2 * axis + 1].position = width;
    p.domain.periodic[axis] = periodic;
  }
  return p;
}

/// The same with grains of one shape, turned at random, so far apart that none overlap.
Packing loose_shapes(std::size_t n, const packing::GrainShape& kind) {
  Packing p = loose<2>(n, true, {5e-3, 7e-3, 0.35});
  const Shape unit = std::visit([](const auto& shape) { return scaled_to(shape.make(), 1); }, kind);
  RandomStream turn(1, Purpose::orientation);
  for (std::size_t k = 0; k < n; ++k) {
    const Shape shape = scaled_to(unit, p.grains.radius[k]);
    add_shape(p.grains.shapes, shape, gyration_of(shape));
    p.grains.angle[k] = turn.uniform(0, 2 * std::numbers::pi);
  }
  return p;
}

/// Mean force on the sides over their lengths or areas.
template <int D> double pressure(const dem::EngineIn<D>& engine) {
  const DomainIn<D>& d = engine.domain;
  double content = 1, sum = 0;
  for (int axis = 0; axis < D; ++axis) content *= d.extent(axis);
  for (int axis = 0; axis < D; ++axis)
    sum += (d.wall[2 * axis].force + d.wall[2 * axis + 1].force) / (2 * content / d.extent(axis));
  return sum / D;
}

template <int D> dem::WallDrivesIn<D> closing(double speed) {
  dem::WallDrivesIn<D> drives;
  for (int side = 0; side < 2 * D; ++side)
    drives[static_cast<std::size_t>(side)] = {dem::WallDrive::Kind::velocity, side % 2 == 0 ? speed : -speed};
  return drives;
}

template <int D> PackingIn<D> jammed(const PackingIn<D>& start) {
  dem::IntegrationParameters integration;
  integration.drag = 20;
  dem::EngineIn<D> engine(start, contact_parameters(), integration);
  set_friction(engine, 0.02);
  const double target = target_pressure * stiffness / std::pow(start.grains.mean_diameter(), D - 2);
  const double fast = 0.06 * engine.domain.extent(0) / (15000 * engine.dt);
  for (double speed = fast; speed > 0.02 * fast; speed *= 0.5) {  // ever slower; what is too much opens again
    const double sign = pressure(engine) < target ? 1.0 : -1.0;
    set_drives(engine, closing<D>(sign * speed));
    while (sign * (target - pressure(engine)) > 0) engine.advance(50);
  }
  set_drives(engine, dem::WallDrivesIn<D>{});
  set_friction(engine, std::nullopt);
  engine.advance(10000);
  return packing_of(engine);
}

/// The cell so many times along each axis.
template <int D> PackingIn<D> tiled(const PackingIn<D>& cell, const std::array<int, D>& times) {
  PackingIn<D> p = cell;
  p.grains = {};
  p.contacts = {};
  const std::size_t n = cell.grains.size();
  std::size_t all = 1;
  for (const int t : times) all *= static_cast<std::size_t>(t);
  p.grains.resize(n * all);
  for (std::size_t copy = 0; copy < all; ++copy) {
    const Vec<D> shift = by_axis<D>([&, at = copy](int axis) mutable {
      const auto count = static_cast<std::size_t>(times[static_cast<std::size_t>(axis)]);
      const double cells = static_cast<double>(at % count);
      at /= count;
      return cells * cell.domain.extent(axis);
    });
    for (std::size_t q = 0; q < n; ++q) {
      const std::size_t k = copy * n + q;
      p.grains.position[k] = cell.grains.position[q] + shift;
      p.grains.radius[k] = cell.grains.radius[q];
      p.grains.angle[k] = cell.grains.angle[q];
    }
  }
  for (int axis = 0; axis < D; ++axis)
    p.domain.wall[2 * axis + 1].position =
        p.domain.wall[2 * axis].position + times[static_cast<std::size_t>(axis)] * cell.domain.extent(axis);
  return p;
}

/// The same of grains that are no disks.
Packing tiled_shapes(const Packing& cell, const std::array<int, 2>& times) {
  Packing p = tiled<2>(cell, times);
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const std::size_t q = k % cell.grains.size();
    add_shape(p.grains.shapes, shape_of(cell.grains, q), cell.grains.shapes.gyration[q]);
  }
  return p;
}

/// 1000 spheres in a periodic cell.
const PackingIn<3>& spheres_1000() {
  static const PackingIn<3> packing = jammed(loose<3>(1000, true, {4e-3, 8e-3, 0.5}));
  return packing;
}

}  // namespace

dem::ContactParameters contact_parameters() {
  dem::ContactParameters contact;
  contact.friction_law = dem::RegularisedCoulomb{};
  contact.attractive_dashpot = true;
  contact.restitution = 0.3;
  return contact;
}

dem::ParallelBond bond() {
  dem::ParallelBond bond;
  bond.modulus = 1e8;
  bond.tensile_strength = bond.cohesion = 1e30;
  bond.gap = 0.05;
  return bond;
}

const Packing& walls_4000() {
  static const Packing packing = jammed(loose<2>(4000, false));
  return packing;
}

const Packing& periodic_4000() {
  static const Packing packing = jammed(loose<2>(4000, true));
  return packing;
}

const Packing& periodic_100000() {
  static const Packing packing = tiled<2>(periodic_4000(), {5, 5});
  return packing;
}

const Packing& clumps_4000() {
  static const Packing packing = tiled_shapes(jammed(loose_shapes(1000, packing::ClumpShape{.aspect = 1.4})), {2, 2});
  return packing;
}

const Packing& polygons_4000() {
  static const Packing packing = tiled_shapes(jammed(loose_shapes(1000, packing::PolygonShape{.corners = 5})), {2, 2});
  return packing;
}

const PackingIn<3>& spheres_4000() {
  static const PackingIn<3> packing = tiled<3>(spheres_1000(), {2, 2, 1});
  return packing;
}

const PackingIn<3>& spheres_100000() {
  static const PackingIn<3> packing = tiled<3>(spheres_1000(), {5, 5, 4});
  return packing;
}

const PackingIn<3>& spheres_1000000() {
  static const PackingIn<3> packing = tiled<3>(spheres_1000(), {10, 10, 10});
  return packing;
}

}  // namespace arenite::bench
