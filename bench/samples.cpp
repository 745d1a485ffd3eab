#include "samples.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"
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

/// Grains on a jittered square lattice in mixed order.
Packing loose(std::size_t n, bool periodic, const Sizes& sizes = {}) {
  Packing p;
  p.materials = {{"grain", 1000.0, stiffness, 0.0}};
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  p.grains.resize(n);
  RandomStream size(1, Purpose::radius), place(1, Purpose::position), order(1, Purpose::order);
  double area = 0;
  for (auto& r : p.grains.radius) {
    r = size.uniform(sizes.from, sizes.to);
    area += std::numbers::pi * r * r;
  }
  const double width = std::sqrt(area / sizes.solid_fraction), pitch = width / static_cast<double>(side);
  std::vector<std::size_t> site(side * side);
  for (std::size_t k = 0; k < site.size(); ++k) site[k] = k;
  for (std::size_t k = site.size() - 1; k > 0; --k) std::swap(site[k], site[order.below(k + 1)]);
  for (std::size_t k = 0; k < n; ++k) {
    p.grains.position[k] = {(static_cast<double>(site[k] % side) + place.uniform(0.45, 0.55)) * pitch,
                            (static_cast<double>(site[k] / side) + place.uniform(0.45, 0.55)) * pitch};
  }
  p.domain.wall[right].position = p.domain.wall[top].position = width;
  p.domain.periodic[0] = p.domain.periodic[1] = periodic;
  return p;
}

/// The same with grains of one shape, turned at random, so far apart that none overlap.
Packing loose_shapes(std::size_t n, const packing::GrainShape& kind) {
  Packing p = loose(n, true, {5e-3, 7e-3, 0.35});
  const Shape unit = std::visit([](const auto& shape) { return scaled_to(shape.make(), 1); }, kind);
  RandomStream turn(1, Purpose::orientation);
  for (std::size_t k = 0; k < n; ++k) {
    const Shape shape = scaled_to(unit, p.grains.radius[k]);
    add_shape(p.grains.shapes, shape, gyration_of(shape));
    p.grains.angle[k] = turn.uniform(0, 2 * std::numbers::pi);
  }
  return p;
}

double pressure(const dem::Engine& engine) {
  const Domain& d = engine.domain;
  return 0.5 * ((d.wall[left].force + d.wall[right].force) / (2 * d.height()) +
                (d.wall[bottom].force + d.wall[top].force) / (2 * d.width()));
}

dem::WallDrives closing(double speed) {
  using Kind = dem::WallDrive::Kind;
  return {{{Kind::velocity, speed}, {Kind::velocity, -speed}, {Kind::velocity, speed}, {Kind::velocity, -speed}}};
}

Packing jammed(const Packing& start) {
  dem::IntegrationParameters integration;
  integration.drag = 20;
  dem::Engine engine(start, contact_parameters(), integration);
  set_friction(engine, 0.02);
  const double fast = 0.06 * engine.domain.width() / (15000 * engine.dt);
  for (double speed = fast; speed > 0.02 * fast; speed *= 0.5) {  // ever slower; what is too much opens again
    const double sign = pressure(engine) < target_pressure * stiffness ? 1.0 : -1.0;
    set_drives(engine, closing(sign * speed));
    while (sign * (target_pressure * stiffness - pressure(engine)) > 0) engine.advance(50);
  }
  set_drives(engine, {});
  set_friction(engine, std::nullopt);
  engine.advance(10000);
  return packing_of(engine);
}

Packing tiled(const Packing& cell, int times) {
  Packing p = cell;
  p.grains = {};
  p.contacts = {};
  const std::size_t n = cell.grains.size();
  p.grains.resize(n * static_cast<std::size_t>(times * times));
  const double width = cell.domain.width(), height = cell.domain.height();
  std::size_t k = 0;
  for (int row = 0; row < times; ++row)
    for (int column = 0; column < times; ++column)
      for (std::size_t q = 0; q < n; ++q, ++k) {
        p.grains.position[k] = {cell.grains.position[q].x + column * width, cell.grains.position[q].y + row * height};
        p.grains.radius[k] = cell.grains.radius[q];
        p.grains.angle[k] = cell.grains.angle[q];
        if (!cell.grains.shapes.empty())
          add_shape(p.grains.shapes, shape_of(cell.grains, q), cell.grains.shapes.gyration[q]);
      }
  p.domain.wall[right].position = p.domain.wall[left].position + times * width;
  p.domain.wall[top].position = p.domain.wall[bottom].position + times * height;
  return p;
}

}  // namespace

dem::ContactParameters contact_parameters() {
  dem::ContactParameters contact;
  contact.friction_law = dem::RegularisedCoulomb{};
  contact.attractive_dashpot = true;
  contact.restitution = 0.3;
  return contact;
}

const Packing& walls_4000() {
  static const Packing packing = jammed(loose(4000, false));
  return packing;
}

const Packing& periodic_4000() {
  static const Packing packing = jammed(loose(4000, true));
  return packing;
}

const Packing& periodic_100000() {
  static const Packing packing = tiled(periodic_4000(), 5);
  return packing;
}

const Packing& clumps_4000() {
  static const Packing packing = tiled(jammed(loose_shapes(1000, packing::ClumpShape{.aspect = 1.4})), 2);
  return packing;
}

const Packing& polygons_4000() {
  static const Packing packing = tiled(jammed(loose_shapes(1000, packing::PolygonShape{.corners = 5})), 2);
  return packing;
}

}  // namespace arenite::bench
