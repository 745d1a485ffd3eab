#include "grains/dem/measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "grains/dem/forces.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/rolling.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

template <int D> void add_contacts(const SampleIn<D>& s, PackingIn<D>& out) {
  const auto grain = [&](std::int32_t disk) { return disk < 0 ? disk : grain_of(s, disk); };
  std::vector<std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t, std::size_t>>
      rows;  // grains, disks, slot
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    if (!(slot_kinematics(s, p).overlap > 0)) continue;
    std::int32_t a = s.record[s.list.i[p]].grain, b = s.list.j[p] < 0 ? s.list.j[p] : s.record[s.list.owner[p]].grain;
    if (b >= 0 && b < a) std::swap(a, b);
    rows.emplace_back(grain(a), grain(b), a, b, p);
  }
  std::ranges::sort(rows);
  for (const auto& [i, j, disk_i, disk_j, slot] : rows) {
    const Kinematics<D> c = slot_kinematics(s, slot);
    const bool swapped = s.record[s.list.i[slot]].grain != disk_i;
    const Vec<D> f = s.list.force[slot].on_i;
    const double fn = dot(f, c.normal);
    const Turning<D> ft = cross(c.normal, f);
    if (swapped) out.contacts.add(i, j, -c.normal, fn, ft, c.arm_j, c.arm_i);
    else out.contacts.add(i, j, c.normal, fn, ft, c.arm_i, c.arm_j);
    each_part(s, [&, slot = slot](const auto& part) { part.report_contact(s, slot, swapped, out); });
    out.contacts.overlap.back() = c.overlap;
    out.contacts.sliding_velocity.back() = c.sliding;
    out.contacts.glued.back() = s.list.strength[slot] > 0 ? 1 : 0;
  }
}

/// Of a mover that moves so, J; 0 of one that goes with a wall.
template <int D> double kinetic_energy(const SampleIn<D>& s, std::size_t k, const Motion<D>& v) {
  if (is_held(s, k)) return 0;
  using lane::dot;
  const Mover<D> m = mover_at(s, k);
  return 0.5 * m.mass * dot(v.velocity, v.velocity) + dot(0.5 * m.inertia * v.omega, v.omega);
}

/// Velocity of the sample as a whole along the axes along which nothing holds it, m/s: a motion of which its grains
/// feel nothing.
template <int D> Vec<D> drift_of(const SampleIn<D>& s) {
  const auto is_free = [&](int axis) {
    return any_part(s, [&](const auto& part) { return part.lets_drift(s, axis); });
  };
  const Vec<D> free = by_axis<D>([&](int axis) { return is_free(axis) ? 1.0 : 0.0; });
  if (free == Vec<D>{}) return {};
  double mass = 0;
  Vec<D> momentum;
  each_mover(s, [&](std::size_t k) {
    const double m = mover_at(s, k).mass;
    mass += m, momentum += m * motion_of(s, k).velocity;
  });
  return by_axis<D>([&](int axis) { return free[axis] * momentum[axis] / mass; });
}

/// Force on a mover, its weight included, N; 0 on one that goes with a wall.
template <int D> double resultant_of(const SampleIn<D>& s, std::size_t k) {
  if (is_held(s, k)) return 0;
  const Vec<D> f = load_on(s, k).force + mover_at(s, k).mass * s.gravity;
  return k < s.count ? hypotenuse(f) : norm(f);
}

/// What holds a mover: contacts that press or pull, and what friction holds from spinning.
template <int D> struct Hold {
  int contacts = 0;
  int points = 0;        ///< where it is rubbed, in directions that differ; three hold it from any spin
  Vec<D> first, second;  ///< towards them from the centre, of unit length
  Vec<D> axis;           ///< of one or two points: what rubs a sphere on it does not resist a spin about it

  void rub(Vec<D> point, bool resists_twisting) {
    constexpr double apart = 1e-3;  // points that are nearer leave the same twist
    const auto is_apart = [&](Vec<D> other) { return norm(point - other) > apart; };
    if (resists_twisting) points = 3;
    else if (points == 0) first = axis = point, points = 1;
    else if (points == 1 && is_apart(first)) second = point, axis = along(point - first), points = 2;
    else if (points == 2 && is_apart(first) && is_apart(second)) points = 3;
  }
  /// A spin, less what no contact resists: all of it without friction, in space the twist about the line through the
  /// points.
  Turning<D> resisted(Turning<D> spin) const {
    return points == 0 ? Turning<D>{} : points < 3 ? without_twist(spin, axis) : spin;
  }

 private:
  static Vec<D> along(Vec<D> v) { return 1 / norm(v) * v; }
};

/// Grains that carry force between two contacts or more, and the loose others, apart: a loose grain moves on for long
/// without moving the others, and its weight is nothing beside their forces, so that it is at rest or not by a measure
/// of its own. A grain that no friction holds spins for ever and moves nobody by it: its spin is no motion then.
/// Contacts that press less than `nothing` of the mean force hold nobody, nor does their friction stop a spin in any
/// time.
struct Motions {
  double bearing = 0, loose = 0;  ///< kinetic energies, J
  std::size_t falling = 0;        ///< loose grains more than half of whose weight nothing holds
};

constexpr double nothing = 1e-6;

template <int D> Motions motions_of(const SampleIn<D>& s, const std::vector<Hold<D>>& holds) {
  const double g = norm(s.gravity);
  const Vec<D> drift = drift_of(s);
  Motions motions;
  each_mover(s, [&](std::size_t k) {
    const bool loose = holds[k].contacts < 2;
    Motion<D> motion = motion_of(s, k);
    motion.velocity = motion.velocity - drift;
    if (k < s.count) motion.omega = holds[k].resisted(motion.omega);
    (loose ? motions.loose : motions.bearing) += kinetic_energy(s, k, motion);
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

template <int D> double adhesive_energy(const SampleIn<D>& s) {
  double sum = 0;
  s.laws.adhesion.visit([&](const auto& adhesion) {
    for (std::size_t p = 0; p < s.list.pairs; ++p)
      if (const Kinematics<D> c = slot_kinematics(s, p); c.overlap > 0)
        sum += adhesion.energy(c.overlap, s.list.strength[p]);
  });
  return sum;
}

template <int D> PackingIn<D> packing_of(const SampleIn<D>& s) {
  PackingIn<D> out;
  out.materials = s.start.materials;
  out.domain = domain_now(s);
  out.grains = grains_of(s);
  const CellMotion<D> cell = cell_motion(out.domain);
  each_mover(s, [&](std::size_t k) {
    const Mover<D> m = mover_at(s, k);
    const Motion<D> own = motion_of(s, k);
    put_grain(out.grains, m.grain, place_of(s, k), m.angle, {own.velocity + cell.at(m.place), own.omega});
  });
  add_contacts(s, out);
  each_part(s, [&](const auto& part) { part.report(s, out); });
  return out;
}

template <int D> Energies energies_of(const SampleIn<D>& s) {
  Energies e = s.tally;
  each_mover(s, [&](std::size_t k) { e.kinetic += kinetic_energy(s, k, motion_of(s, k)); });
  for (int side = 0; side < sides_in<D>; ++side)
    if (s.wall[side].drive.kind == DriveKind::force) {
      const double v = wall_rate(s, side);
      e.kinetic += 0.5 * s.wall[side].mass * v * v;
    }
  e.adhesive = adhesive_energy(s);
  e.elastic += rolling_energy(s);
  each_part(s, [&](const auto& part) { part.add_energy(s, e); });
  s.laws.visit([&]<class N, class A, class F>(const N& normal, const A&, const F& friction) {
    const ContactListIn<D>& list = s.list;
    for (std::size_t p = 0; p < list.size(); ++p) {
      const Kinematics<D> c = slot_kinematics(s, p);
      if (!(c.overlap > 0)) continue;
      const double remembered = N::remembers ? list.normal_memory[p] : 0.0;
      e.elastic += normal.energy(c.overlap, list.stiffness[p], c.curvature, remembered) +
                   friction.energy(s.laws.slip(c.sliding, sliding_stiffness(s, normal, p, c)), list.memory[p]);
    }
  });
  return e;
}

template <int D> Equilibrium equilibrium_of(const SampleIn<D>& s) {
  Equilibrium q;
  std::vector<Hold<D>> holds(s.count + body_count(s));
  std::vector<double> held_by(s.list.size(), 0);  // N, by slot
  const auto grains = static_cast<double>(grain_count(s));
  double resultant = 0, normal_sum = 0, mobilised = 0;
  std::size_t contacts = 0, pressed = 0;
  each_mover(s, [&](std::size_t k) { resultant += resultant_of(s, k); });
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    const Kinematics<D> c = slot_kinematics(s, p);
    const double pull = sum_of_parts(s, [&](const auto& part) { return part.pull_of(p); });
    const bool touches = c.overlap > 0;
    if (!touches && !(pull > 0)) continue;
    const Vec<D> force = s.list.force[p].on_i;
    const double fn = touches ? dot(force, c.normal) : 0.0;
    normal_sum += touches ? std::abs(fn) : pull;
    ++contacts;
    if (fn > 0) {
      mobilised += size_of(cross(c.normal, force)) / fn;
      ++pressed;
    }
    held_by[p] = std::max(fn, pull);  // a pull holds its grains, whatever presses them
  }
  each_part(s, [&](const auto& part) {
    part.each_joint(s, [&](std::int32_t i, std::int32_t j, double size) {
      normal_sum += size;
      ++contacts;
      for (const std::int32_t k : {i, j}) {
        Hold<D>& hold = holds[moving(s, k)];
        ++hold.contacts;
        hold.points = 3;
      }
    });
  });
  const double least = contacts > 0 ? nothing * normal_sum / static_cast<double>(contacts) : 0;
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    if (!(held_by[p] > least)) continue;
    const Vec<D> normal = slot_kinematics(s, p).normal;
    const bool rubs = (p < s.list.pairs ? s.friction : s.wall_friction) > 0 || !s.contact.rolls_freely();
    const auto hold = [&](std::int32_t k, Vec<D> point) {
      ++holds[moving(s, k)].contacts;
      if (rubs) holds[moving(s, k)].rub(point, resists_twisting(s));
    };
    hold(s.list.i[p], -normal);
    if (s.list.j[p] >= 0) hold(s.list.owner[p], normal);
  }
  if (s.count > 0 && resultant > 0)
    q.unbalanced_ratio = normal_sum > 0 ? (resultant / grains) * static_cast<double>(contacts) / normal_sum
                                        : std::numeric_limits<double>::infinity();
  const Motions motions = motions_of(s, holds);
  const double elastic = energies_of(s).elastic;
  q.kinetic_ratio = over_elastic(motions.bearing, elastic);
  q.loose_kinetic = over_elastic(motions.loose, elastic);
  if (s.count > 0) q.falling = static_cast<double>(motions.falling) / grains;
  if (pressed > 0) q.mobilisation = mobilised / static_cast<double>(pressed);
  each_part(s, [&](const auto& part) { q.wall_speed = std::max(q.wall_speed, part.fastest_point(s)); });
  for (int side = 0; side < sides_in<D>; ++side) q.wall_speed = std::max(q.wall_speed, std::abs(wall_rate(s, side)));
  return q;
}

template <int D> Amount amount_below(const SampleIn<D>& s, double height) {
  Amount amount;
  each_mover(s, [&](std::size_t k) {
    if (!(mover_at(s, k).place.y < height)) return;
    ++amount.grains;
    amount.mass += own_mass_of(s, mover_at(s, k).grain);
  });
  return amount;
}

template double adhesive_energy(const SampleIn<2>&);
template double adhesive_energy(const SampleIn<3>&);
template Packing packing_of(const SampleIn<2>&);
template PackingIn<3> packing_of(const SampleIn<3>&);
template Energies energies_of(const SampleIn<2>&);
template Energies energies_of(const SampleIn<3>&);
template Equilibrium equilibrium_of(const SampleIn<2>&);
template Equilibrium equilibrium_of(const SampleIn<3>&);
template Amount amount_below(const SampleIn<2>&, double);
template Amount amount_below(const SampleIn<3>&, double);

}  // namespace arenite::dem
