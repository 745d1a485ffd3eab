#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/integrators/integrators.hpp"

/// Small samples whose motion is known in closed form, and the few quantities read off them.
namespace arenite::verification {

using std::numbers::pi;

inline constexpr double gravity = 9.81;   ///< m/s^2
inline constexpr double k_pom = 27.35e6;  ///< N/m
inline constexpr double k_hdpe = 6.43e6;  ///< N/m
inline constexpr std::int32_t pom = 0, hdpe = 1;

struct Disk {
  Vec2 centre;
  double radius = 6.2e-3;
  std::int32_t material = pom;
  Vec2 velocity = {};
  double spin = 0;
  std::uint8_t zone = 0;
};

/// Four walls around [0, width] x [0, height], cylinders 60 mm long, POM and HDPE as materials 0 and 1.
inline Packing box(double width, double height) {
  Packing p;
  p.materials = {{"POM", 1410, k_pom, 0.0150e-6}, {"HDPE", 950, k_hdpe, 0.0258e-6}};
  p.domain.thickness = 0.06;
  p.domain.wall[right].position = width;
  p.domain.wall[top].position = height;
  return p;
}

inline Packing periodic_cell(double width, double height) {
  Packing p = box(width, height);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  for (Wall& wall : p.domain.wall) wall.present = false;
  return p;
}

inline void add(Packing& p, const Disk& disk) {
  Grains& g = p.grains;
  const std::size_t i = g.size();
  g.resize(i + 1);
  g.position[i] = disk.centre;
  g.radius[i] = disk.radius;
  g.material[i] = disk.material;
  g.velocity[i] = disk.velocity;
  g.omega[i] = disk.spin;
  g.zone[i] = disk.zone;
}

inline double mass(const Packing& p, std::size_t i) {
  const Grains& g = p.grains;
  return p.materials[static_cast<std::size_t>(g.material[i])].density * pi * g.radius[i] * g.radius[i] *
         p.domain.thickness;
}
inline double disk_inertia(const Packing& p, std::size_t i) {
  return 0.5 * mass(p, i) * p.grains.radius[i] * p.grains.radius[i];
}
inline double reduced(double a, double b) { return a * b / (a + b); }
inline Vec2 velocity(const Packing& p, std::size_t i) { return p.grains.velocity[i]; }

inline Vec2 momentum(const Packing& p) {
  Vec2 sum;
  for (std::size_t i = 0; i < p.grains.size(); ++i) sum += mass(p, i) * velocity(p, i);
  return sum;
}
inline double angular_momentum(const Packing& p, Vec2 about) {
  double sum = 0;
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    sum += mass(p, i) * cross(p.grains.position[i] - about, velocity(p, i)) + disk_inertia(p, i) * p.grains.omega[i];
  return sum;
}
inline double weight(const Packing& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.grains.size(); ++i) sum += mass(p, i) * gravity;
  return sum;
}

/// Half period of the undamped contact.
inline double contact_time(double m_eff, double k) { return pi * std::sqrt(m_eff / k); }
/// Share of critical damping that gives restitution e while the spring-dashpot pulls at the end: e = exp(-pi
/// zeta/sqrt(1 - zeta^2)).
inline double damping_ratio(double e) {
  const double l = -std::log(e);
  return l / std::hypot(pi, l);
}

inline dem::ContactParameters frictionless(double restitution) {
  dem::ContactParameters c;
  c.friction_law = dem::NoFriction{};
  c.restitution = restitution;
  c.attractive_dashpot = true;
  return c;
}
/// Springs only: nothing dissipates.
inline dem::ContactParameters elastic() {
  dem::ContactParameters c = frictionless(1);
  c.normal_damping = 0;
  return c;
}
inline dem::IntegrationParameters with_step(double dt,
                                            dem::IntegratorKind kind = dem::IntegratorKind::velocity_verlet) {
  dem::IntegrationParameters p;
  p.time_step = dt;
  p.integrator = kind;
  return p;
}
#define ARENITE_KIND(name) dem::IntegratorKind::name,
inline constexpr dem::IntegratorKind integrators[] = {ARENITE_INTEGRATORS(ARENITE_KIND)};
#undef ARENITE_KIND
inline const char* name(dem::IntegratorKind kind) { return dem::integrator_of(kind).word.word.data(); }

/// Energy that is in the sample, that it has lost, and that was put in; their sum holds.
inline double stored(const Energies& e) { return e.kinetic + e.elastic + e.adhesive; }
inline double lost(const Energies& e) {
  return e.dissipated_normal + e.dissipated_friction + e.dissipated_drag + e.dissipated_breakage;
}
inline double work(const Energies& e) { return e.work_walls + e.work_gravity; }

inline std::optional<std::size_t> find_contact(const Packing& p, std::int32_t i, std::int32_t j) {
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    if ((p.contacts.i[c] == i && p.contacts.j[c] == j) || (p.contacts.i[c] == j && p.contacts.j[c] == i)) return c;
  return std::nullopt;
}

/// Disks of radius 5.9-6 mm and both materials on a slightly shaken triangular lattice, nearly touching each other and
/// the walls (or, if periodic, their images): a sample that a wall's move of a millimetre compresses.
inline Packing shaken_lattice(int columns, int rows, std::uint64_t seed, bool periodic = false, double speed = 0) {
  constexpr double largest = 6e-3;
  const double pitch = 2 * largest, row = pitch * std::sqrt(0.75);
  const double width = pitch * (periodic ? columns : columns + 0.5);
  const double height = row * rows + (periodic ? 0 : pitch - row);
  Packing p = periodic ? periodic_cell(width, height) : box(width, height);
  RandomStream random(seed, Purpose::test);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      Disk disk;
      disk.radius = largest * random.uniform(0.984, 1);
      disk.material = random.uniform() < 0.5 ? pom : hdpe;
      const double shake = largest - disk.radius;
      disk.centre = {largest + pitch * (c + 0.5 * (r % 2)) + shake * random.uniform(-0.5, 0.5),
                     largest + row * r + shake * random.uniform(-0.5, 0.5)};
      disk.velocity = {speed * random.uniform(-1, 1), speed * random.uniform(-1, 1)};
      disk.spin = speed / largest * random.uniform(-1, 1);
      add(p, disk);
    }
  return p;
}

/// Below every T_c = pi sqrt(m_eff/k) of the lattice above: half of its lightest disk on k of POM.
inline double shortest_contact_time() { return contact_time(0.5 * 950 * pi * 5.9e-3 * 5.9e-3 * 0.06, k_pom); }

inline dem::WallDrive moved(double speed) { return {dem::WallDrive::Kind::velocity, speed}; }
inline dem::WallDrive pressed(double force) { return {dem::WallDrive::Kind::force, force}; }

/// Steps in blocks until the sample is at rest by the ledger's criterion; false if it never is.
inline bool settle(dem::Engine& engine, double unbalanced = 1e-6, double kinetic = 1e-12, int blocks = 400,
                   std::int64_t block = 500) {
  for (int b = 0; b < blocks; ++b) {
    engine.advance(block);
    const Equilibrium e = equilibrium_of(engine);
    if (e.unbalanced_ratio < unbalanced && e.kinetic_ratio < kinetic) return true;
  }
  return false;
}

}  // namespace arenite::verification
