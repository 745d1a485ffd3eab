#include "grains/dem/bodies/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "grains/dem/bodies/crowd.hpp"
#include "grains/dem/bodies/feet.hpp"
#include "grains/dem/bodies/make.hpp"
#include "grains/dem/bodies/motion.hpp"
#include "grains/dem/glue.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {
namespace {

/// Torque about the disk of a foot's polygon that takes it, by the way from there to the foot, where the slot's force
/// acts.
double shifted_torque(const Sample& s, std::size_t slot, const Foot& foot) {
  const Vec2 on_i = s.list.force[slot].on_i;
  if (is_boundary(foot.touches)) return cross(foot.lever - the<Bodies>(s).lever[s.list.i[slot]], on_i);
  return cross(foot.lever - the<Bodies>(s).lever[s.list.owner[slot]], -on_i);
}

/// Of a body in a crowd of its like. Translation and rotation may act together.
Rates crowded_rates(const Sample& s, const Body& b, const SlopesOf<2>& slopes_between_equals) {
  const DiskRecord& d = s.record[the<Bodies>(s).disk[b.first]];
  const Crowd crowd = crowd_around(s, b);
  const double turning = s.integration.rotations ? 2.0 / b.inertia() : 0.0, area = crowd.contacts * d.radius * d.radius;
  const auto rate = [&](const Slopes& of) {
    return crowd.contacts * (of.normal + of.sliding) / b.mass +
           turning * (of.normal * crowd.normal_levers + of.sliding * crowd.tangential_levers + of.rolling * area);
  };
  const ContactSlopes slopes = slopes_between_equals(d);
  return {rate(slopes.springs), rate(slopes.dashpots)};
}

}  // namespace

void Bodies::check(Problems& problems, const Packing& start, const ContactParameters& contact,
                   const IntegrationParameters& integration) {
  check_shapes(problems, start, contact, integration);
}

void Bodies::make(Sample& s, const Packing& given) {
  if (given.grains.shapes.empty()) return;
  s.start = disks_of(given);
  make_bodies(s, given.grains);
}

double Bodies::least_cell(const Sample& s) const {
  double reach_of_body = 0;
  for (std::size_t d = 0; d < part.size(); ++d)
    reach_of_body = std::max(reach_of_body, norm(part[d].place) + s.start.grains.radius[d]);
  return 4 * reach_of_body + 2 * s.skin;
}

void Bodies::wrap(Sample& s) { wrap_bodies(s); }

void Bodies::number(Sample& s) {
  number_parts(s);
  foot.clear();
  point_foot.clear();
}

/// Slots of disks that may touch polygons.
void Bodies::list_pairs(Sample& s, const ThreadPool& pool) {
  if (body.empty()) return;
  foot = find_feet(s, pool);
  ContactList& list = s.list;
  const std::size_t ghosts = s.ghost.size();
  for (const Foot& each : foot) {
    const std::int32_t owner = disk[body[each.body].first];
    s.ghost.push_back({owner, each.shift});
    add_slot(list, each.touches, static_cast<std::int32_t>(s.count + s.ghost.size() - 1), owner,
             pair_coefficients(s, s.record[each.touches], s.record[owner]));
  }
  list.pairs += s.ghost.size() - ghosts;
  s.record.resize(s.count + s.ghost.size());
  refresh_feet(s);
}

/// Slots of polygons that may touch points of boundaries.
void Bodies::list_others(Sample& s) {
  point_foot = find_point_feet(s);
  for (const Foot& each : point_foot) {
    const std::int32_t first = disk[body[each.body].first];
    add_slot(s.list, first, each.touches, -1, s.coefficients.wall(s.record[first]));
  }
  s.record.resize(s.count + s.ghost.size() + point_foot.size());
  refresh_feet(s);
}

void Bodies::refresh(Sample& s) { refresh_feet(s); }

bool Bodies::can_meet(const Sample& s, std::int32_t i, std::int32_t j) const {
  const std::int32_t a = body_of(s.record[i].grain), b = body_of(s.record[j].grain);
  const auto is_corner = [&](std::int32_t of) { return of >= 0 && body[of].filled != 0; };
  return !is_corner(a) && !is_corner(b) && (a < 0 || a != b);
}

void Bodies::add_forces(Sample& s, const ThreadPool& pool) {
  const std::size_t feet = foot.size(), first = s.list.pairs - feet, points = point_foot.size();
  if (feet + points == 0) return;
  pool.for_ranges(feet + points, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t slot = n < feet ? first + n : s.list.polygons + n - feet;
      SlotForce<2>& force = s.list.force[slot];
      if (acts(force)) (n < feet ? force.torque_j : force.torque_i) += shifted_torque(s, slot, *foot_of(s, slot));
    }
  });
}

void Bodies::raise_rates(const Sample& s, const SlopesOf<2>& slopes, Rates& rates) const {
  for (const Body& b : body) {
    const Rates crowded = crowded_rates(s, b, slopes);
    rates.frequency_squared = std::max(rates.frequency_squared, crowded.frequency_squared);
    rates.damping = std::max(rates.damping, crowded.damping);
  }
}

double Bodies::shortest_time(const Sample& s, const std::function<double(double)>& tangent) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Body& b : body) {
    const DiskRecord& d = s.record[disk[b.first]];
    const double pair = 0.5 / tangent(s.coefficients.pair_stiffness(d, d));
    const double wall = 1 / tangent(s.coefficients.wall_stiffness(d));
    shortest = std::min(shortest, std::numbers::pi * std::sqrt(lightest_mass(s, b) * std::min(pair, wall)));
  }
  return shortest;
}

bool Bodies::follow(Sample& s, const SweepTask<2>& task, const ThreadPool& pool) { return move_bodies(s, task, pool); }

bool Bodies::moves_all_disks(const Sample& s) const {
  std::size_t parts = 0;
  for (const Body& b : body) parts += static_cast<std::size_t>(b.count);
  return parts >= s.count;
}

void Bodies::put_mover(std::size_t of, Mover<2>& mover) const {
  const Body& b = body[of];
  mover = {part[b.first].grain, b.mass, b.inertia(), b.gyration, b.place, b.angle, b.own, b.seen};
}

void Bodies::put_load(const Sample& s, std::size_t of, Load<2>& load) const { load = load_of(s, body[of]); }

void Bodies::report_contact(const Sample& s, std::size_t slot, bool swapped, Packing& out) const {
  if (part.empty()) return;
  Levers<2> levers = levers_at(s, slot);
  if (swapped) std::swap(levers.i, levers.j);
  out.contacts.off_i.push_back(levers.i);
  out.contacts.off_j.push_back(levers.j);
}

Levers<2> Bodies::levers_at(const Sample& s, std::size_t slot) const {
  const Foot* at = foot_of(s, slot);
  Levers<2> levers{lever[s.list.i[slot]], {}};
  if (s.list.j[slot] >= 0) levers.j = at ? at->lever : lever[s.list.owner[slot]];
  else if (at) levers.i = at->lever;
  return levers;
}

const Foot* Bodies::foot_of(const Sample& s, std::size_t slot) const {
  if (slot >= s.list.polygons) return &point_foot[slot - s.list.polygons];
  const std::size_t first = s.list.pairs - foot.size();
  return slot >= first && slot < s.list.pairs ? &foot[slot - first] : nullptr;
}

void Bodies::take_masses(const Sample& s) {
  for (Body& b : body) b.mass = s.record[disk[b.first]].mass;
}

void Bodies::note_present(const Sample& s) {
  present.clear();
  for (std::size_t b = 0; b < body.size(); ++b) present.push_back(motion_of(s, s.count + b));
}

void Bodies::go_to_present(Sample& /*sample*/, const Domain& /*now*/) {
  for (std::size_t b = 0; b < body.size(); ++b) body[b].own = present[b];
}

void Bodies::shear(Sample& s, const std::function<double(double)>& faster_at) {
  for (Body& b : body) {
    b.own.velocity.x += faster_at(b.place.y);
    b.seen.velocity.x += faster_at(b.place.y);
  }
  place_parts(s);
}

void place_parts(Sample& s) {
  for (const Body& b : the<Bodies>(s).body) place_parts_of(s, b);
}

Torques own_torques(const Sample& s, std::size_t slot) {
  Torques torques{s.list.force[slot].torque_i, s.list.force[slot].torque_j};
  if (const Foot* foot = the<Bodies>(s).foot_of(s, slot))
    (is_boundary(foot->touches) ? torques.i : torques.j) -= shifted_torque(s, slot, *foot);
  return torques;
}

int rows_between(const Sample& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot], n = static_cast<std::int32_t>(s.count);
  if (j < 0) return 0;
  const Foot* foot = the<Bodies>(s).foot_of(s, slot);
  int rows = foot ? foot->shift.y : j >= n ? s.ghost[j - n].shift.y : 0;
  if (the<Bodies>(s).part.empty()) return rows;
  const auto shift = [&](std::int32_t k) { return the<Bodies>(s).part[s.record[k].grain].shift.y; };
  if (!foot) rows += shift(s.list.owner[slot]);
  return rows - shift(s.list.i[slot]);
}

}  // namespace arenite::dem
