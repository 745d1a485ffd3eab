#include "grains/dem/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

void add_contacts(const Sample& s, Packing& out) {
  struct Row {
    std::int32_t i, j;  ///< disks
    std::size_t slot;
    bool swapped;
  };
  const auto grain = [&](std::int32_t disk) { return disk < 0 ? disk : grain_of(s, disk); };
  std::vector<Row> rows;
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    if (!(slot_kinematics(s, p).overlap > 0)) continue;
    const std::int32_t a = s.record[s.list.i[p]].grain;
    const std::int32_t b = s.list.j[p] < 0 ? s.list.j[p] : s.record[s.list.owner[p]].grain;
    const bool swapped = b >= 0 && b < a;
    rows.push_back(swapped ? Row{b, a, p, true} : Row{a, b, p, false});
  }
  std::sort(rows.begin(), rows.end(),
            [&](const Row& p, const Row& q) { return std::tuple(grain(p.i), grain(p.j), p.i, p.j) < std::tuple(grain(q.i), grain(q.j), q.i, q.j); });
  for (const Row& row : rows) {
    const Kinematics c = slot_kinematics(s, row.slot);
    const Vec2 f = s.list.force[row.slot].on_i;
    const double fn = dot(f, c.normal), ft = dot(f, perpendicular(c.normal));
    if (row.swapped) out.contacts.add(grain(row.i), grain(row.j), -c.normal, fn, ft, c.arm_j, c.arm_i);
    else out.contacts.add(grain(row.i), grain(row.j), c.normal, fn, ft, c.arm_i, c.arm_j);
    if (!s.part.empty()) add_levers(s, row.slot, row.swapped, out.contacts);
    out.contacts.overlap.back() = c.overlap;
    out.contacts.sliding_velocity.back() = c.sliding;
    out.contacts.glued.back() = s.list.strength[row.slot] > 0 ? 1 : 0;
  }
}

/// Of a mover, J; 0 of one that goes with a wall.
double kinetic_energy(const Sample& s, std::size_t k) {
  if (k < s.count && find_held(s, s.record[k].grain)) return 0;
  const Motion v = motion_of(s, k);
  const Mover m = mover_at(s, k);
  return 0.5 * m.mass * dot(v.velocity, v.velocity) + 0.5 * m.inertia * v.omega * v.omega;
}

/// Force on a mover, its weight included, N; 0 on one that goes with a wall.
double resultant_of(const Sample& s, std::size_t k) {
  if (k < s.count && find_held(s, s.record[k].grain)) return 0;
  const Vec2 f = load_on(s, k).force + mover_at(s, k).mass * s.gravity;
  return k < s.count ? std::hypot(f.x, f.y) : norm(f);
}

/// Grains that carry force between two contacts or more, and the loose others, apart: a loose grain moves on for long without moving the others, and
/// its weight is nothing beside their forces, so that it is at rest or not by a measure of its own.
struct Motions {
  double bearing = 0, loose = 0;  ///< kinetic energies, J
  std::size_t falling = 0;        ///< loose grains more than half of whose weight nothing holds
};

Motions motions_of(const Sample& s, const std::vector<int>& pressed_contacts) {
  const double g = norm(s.gravity);
  Motions motions;
  each_mover(s, [&](std::size_t k) {
    const bool loose = pressed_contacts[k] < 2;
    (loose ? motions.loose : motions.bearing) += kinetic_energy(s, k);
    if (loose && g > 0 && resultant_of(s, k) > 0.5 * mover_at(s, k).mass * g) ++motions.falling;
  });
  return motions;
}

/// Of a kinetic energy to the elastic one; 0 where nothing moves.
double over_elastic(double kinetic, double elastic) {
  if (kinetic == 0) return 0;
  return elastic > 0 ? kinetic / elastic : std::numeric_limits<double>::infinity();
}

}  // namespace

double adhesive_energy(const Sample& s) {
  double sum = 0;
  s.laws.adhesion.visit([&](const auto& adhesion) {
    for (std::size_t p = 0; p < s.list.pairs; ++p)
      if (const Kinematics c = slot_kinematics(s, p); c.overlap > 0) sum += adhesion.energy(c.overlap, s.list.strength[p]);
  });
  return sum;
}

Packing packing_of(const Sample& s) {
  Packing out;
  out.materials = s.start.materials;
  out.domain = s.domain;
  out.grains = s.part.empty() ? s.start.grains : s.given;
  for (int side = 0; side < sides; ++side) {
    out.domain.wall[side].velocity = wall_rate(s, side);
    out.domain.wall[side].position = wall_place(s, side);
  }
  for (std::size_t b = 0; b < s.boundary.size(); ++b) out.domain.boundaries[b].velocity = velocity_of(s, b);
  const CellMotion<2> cell = cell_motion(out.domain);
  each_mover(s, [&](std::size_t k) {
    const Mover m = mover_at(s, k);
    const Motion own = motion_of(s, k);
    put_grain(out.grains, m.grain, place_of(s, k), m.angle, {own.velocity + cell.at(m.place), own.omega});
  });
  out.contacts = {};
  add_contacts(s, out);
  out.bonds = bonds_of(s);
  out.cohesive = cohesive_pairs(s);
  return out;
}

Energies energies_of(const Sample& s) {
  Energies e = s.tally;
  each_mover(s, [&](std::size_t k) { e.kinetic += kinetic_energy(s, k); });
  for (int side = 0; side < sides; ++side)
    if (s.wall[side].drive.kind == WallDrive::Kind::force) {
      const double v = wall_rate(s, side);
      e.kinetic += 0.5 * s.wall[side].mass * v * v;
    }
  for (std::size_t b = 0; b < s.boundary.size(); ++b)
    if (const Vec2 v = velocity_of(s, b); s.boundary[b].mass > 0) e.kinetic += 0.5 * s.boundary[b].mass * dot(v, v);
  e.adhesive = adhesive_energy(s) + cohesive_energy(s);
  e.elastic += rolling_energy(s) + bond_energy(s);
  s.laws.visit([&]<class N, class A, class F>(const N& normal, const A&, const F& friction) {
    const ContactList& list = s.list;
    for (std::size_t p = 0; p < list.size(); ++p) {
      const Kinematics c = slot_kinematics(s, p);
      if (!(c.overlap > 0)) continue;
      const double remembered = N::remembers ? list.normal_memory[p] : 0.0;
      e.elastic += normal.energy(c.overlap, list.stiffness[p], c.curvature, remembered) +
                   friction.energy(s.laws.slip(c.sliding, sliding_stiffness(s, normal, p, c)), list.memory[p]);
    }
  });
  return e;
}

Equilibrium equilibrium_of(const Sample& s) {
  Equilibrium q;
  std::vector<int> pressed_contacts(s.count + s.body.size(), 0);
  const auto grains = static_cast<double>(grain_count(s));
  double resultant = 0, normal_sum = 0, mobilised = 0;
  std::size_t contacts = 0, pressed = 0;
  each_mover(s, [&](std::size_t k) { resultant += resultant_of(s, k); });
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    const Kinematics c = slot_kinematics(s, p);
    if (pull_of(s, p) > 0) {  // holds its grains, whatever presses them
      ++pressed_contacts[moving(s, s.list.i[p])];
      ++pressed_contacts[moving(s, s.list.owner[p])];
    }
    if (!(c.overlap > 0)) {
      normal_sum += pull_of(s, p);
      contacts += pull_of(s, p) > 0;
      continue;
    }
    const double fn = dot(s.list.force[p].on_i, c.normal), ft = dot(s.list.force[p].on_i, perpendicular(c.normal));
    normal_sum += std::abs(fn);
    ++contacts;
    if (fn > 0) {
      mobilised += std::abs(ft) / fn;
      ++pressed;
      if (pull_of(s, p) > 0) continue;
      ++pressed_contacts[moving(s, s.list.i[p])];
      if (s.list.j[p] >= 0) ++pressed_contacts[moving(s, s.list.owner[p])];
    }
  }
  for (std::size_t n = 0; n < s.bond_slots.size(); ++n) {
    const BondSlot& b = s.bond_slots[n];
    const SlotForce& f = s.list.force[bond_force_place(s.list, n)];
    if (!acts(f)) continue;
    normal_sum += std::hypot(f.on_i.x, f.on_i.y);
    ++contacts;
    for (const std::int32_t k : {b.i, b.j}) ++pressed_contacts[moving(s, k)];
  }
  if (s.count > 0 && resultant > 0)
    q.unbalanced_ratio = normal_sum > 0 ? (resultant / grains) * static_cast<double>(contacts) / normal_sum : std::numeric_limits<double>::infinity();
  const Motions motions = motions_of(s, pressed_contacts);
  const double elastic = energies_of(s).elastic;
  q.kinetic_ratio = over_elastic(motions.bearing, elastic);
  q.loose_kinetic = over_elastic(motions.loose, elastic);
  if (s.count > 0) q.falling = static_cast<double>(motions.falling) / grains;
  if (pressed > 0) q.mobilisation = mobilised / static_cast<double>(pressed);
  q.wall_speed = fastest_point(s.domain);
  for (int side = 0; side < sides; ++side) q.wall_speed = std::max(q.wall_speed, std::abs(wall_rate(s, side)));
  return q;
}

}  // namespace arenite::dem
