#include "grains/dem/parts/forces_and_rates.hpp"

#include <cstdint>
#include <utility>

#include "grains/dem/boundaries/elements.hpp"
#include "grains/dem/boundaries/faces.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/rolling.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

/// The part of a force that lies along a contact.
Vec2 tangential(Vec2 f, Vec2 normal) {
  const Vec2 t = perpendicular(normal);
  return dot(f, t) * t;
}
Vec3 tangential(Vec3 f, Vec3 normal) { return f - dot(f, normal) * normal; }

/// Of what lies along a side, the part in the n-th direction there.
double component(int /*side*/, double along, int /*n*/) { return along; }
double component(int side, Vec3 along, int n) { return along[(axis_of(side) + 1 + n) % 3]; }

/// Rows of periodic cells between two grains of a slot.
int rows_of(const Sample& s, std::size_t slot) { return rows_between(s, slot); }
int rows_of(const SampleIn<3>& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot], n = static_cast<std::int32_t>(s.count);
  return j >= n ? s.ghost[j - n].shift.y : 0;
}

/// A force and its torque, number by number.
std::array<double, 3> in_a_row(Vec2 force, double torque) { return {force.x, force.y, torque}; }
std::array<double, 6> in_a_row(Vec3 force, Vec3 torque) {
  return {force.x, force.y, force.z, torque.x, torque.y, torque.z};
}

/// Gives a contact's forces to the membrane that it is with; false where there is none.
bool push_nodes(const SampleIn<3>&, std::size_t, const Kinematics<3>&, Vec3, Vec3, ForcesAndRates<3>&) { return false; }
bool push_nodes(const Sample& s, std::size_t slot, const Kinematics<2>& c, Vec2 dash, Vec2 slip,
                ForcesAndRates<2>& shot) {
  const TouchedSkin at = touched_skin(s, slot, c);
  if (!at.of) return false;
  for (const auto& [node, share] : {std::pair{at.node, 1 - at.share}, std::pair{at.next, at.share}})
    for (const int axis : {0, 1})
      shot.node[2 * (at.of->first + node) + static_cast<std::size_t>(axis)].push(-share * dash[axis],
                                                                                 -share * slip[axis]);
  return true;
}

/// What a contact with a boundary does to it, by class, about its centre as well.
template <int D>
void add_boundary_contact(const SampleIn<D>& s, std::size_t slot, const Kinematics<D>& c, Vec<D> dash, Vec<D> slip,
                          ForcesAndRates<D>& shot) {
  if (push_nodes(s, slot, c, dash, slip, shot)) return;
  const std::size_t b = boundary_index(s, s.list.j[slot]);
  const Vec<D> arm = touched_place(s, slot, c) - s.domain.boundaries[b].centre;
  const auto dashes = in_a_row(dash, cross(arm, dash)),
             slips = in_a_row(slip, cross(arm, slip) - s.list.force[slot].torque_j);
  for (std::size_t n = 0; n < dashes.size(); ++n) shot.boundary[dashes.size() * b + n].push(-dashes[n], -slips[n]);
}

/// Adds forces that act on a grain, with their torque about its centre.
template <int D> void push(typename ForcesAndRates<D>::Disk& grain, Vec<D> dash, Vec<D> slip, Turning<D> torque) {
  grain.dash.force += dash;
  grain.slip.force += slip;
  grain.slip.torque += torque;
}

/// The same where they act at a lever from its centre, with their torque about that place.
void push(ForcesAndRates<2>::Disk& grain, Vec2 dash, Vec2 slip, double torque, Vec2 lever) {
  push<2>(grain, dash, slip, torque + cross(lever, slip));
  grain.dash.torque += cross(lever, dash);
}

/// A contact's forces on its two grains, of a wall on the one: those of bodies at their levers.
template <int D> struct Sharers { typename ForcesAndRates<D>::Disk &own, *partner; };
void push_bodies(const Sample& s, std::size_t p, Vec2 dash, Vec2 slip, const Sharers<2>& of) {
  const Levers<2> levers = levers_of(s, p);
  const Torques torques = own_torques(s, p);
  push(of.own, dash, slip, torques.i, levers.i);
  if (of.partner) push(*of.partner, -dash, -slip, torques.j, levers.j);
}
void push_bodies(const SampleIn<3>&, std::size_t, Vec3, Vec3, const Sharers<3>&) {}  // there are none

/// What a contact or bond along `branch`, over so many rows of the periodic cell, does to its edges and its shear.
template <int D>
void add_to_cell(const SampleIn<D>& s, Vec<D> branch, int rows, Vec<D> force, Vec<D> dash, Vec<D> slip,
                 ForcesAndRates<D>& shot) {
  auto& shear = shot.edge[shot.cell_shear];
  shear.force -= rows * force.x;
  shear.push(-rows * dash.x, -rows * slip.x);
  for (int axis = 0; axis < D; ++axis)
    if (s.domain.periodic[axis]) {
      const double length = s.domain.extent(axis);
      shot.edge[2 * axis].push(-dash[axis] * branch[axis] / length, -slip[axis] * branch[axis] / length);
    }
}

/// What a contact does to a wall.
template <int D> void push_edges(int side, Vec<D> dash, Vec<D> slip, ForcesAndRates<D>& shot) {
  shot.edge[side].push(-across(side, dash), 0);
  for (int n = 0; n < D - 1; ++n)
    shot.edge[shot.slides + side * (D - 1) + n].push(0, -component(side, along(side, slip), n));
}

template <int D> void add_contacts(const SampleIn<D>& s, ForcesAndRates<D>& shot) {
  const auto& coheres_by = the<CohesivePairsIn<D>>(s);
  const ContactListIn<D>& list = s.list;
  shot.springs = rolling_energy(s);
  // What disks in a box have none of is not looked for at each of their contacts.
  const bool has_levers = !has_disks_only(s), in_cell = s.domain.is_cell(), coheres = coheres_by.remembers(),
             shears = s.shear_rate != 0;
  s.laws.visit([&]<class N, class A, class F>(const N& normal, const A& adhesion, const F& friction) {
    for (std::size_t p = 0; p < list.size(); ++p) {
      const Kinematics<D> c = p < list.pairs ? pair_kinematics(s.record[list.i[p]], s.record[list.j[p]], s.contact.arms)
                                             : slot_kinematics(s, p);
      if (shears && coheres && !(c.overlap > 0) && coheres_by.pull_of(p) > 0)
        shot.edge[shot.cell_shear].force -= rows_of(s, p) * list.force[p].on_i.x;
      if (!(c.overlap > 0)) continue;  // a clipped contact has no force, but its dashpot eats what its spring gives
      const Vec<D> f = list.force[p].on_i;
      double spring = -adhesion.attraction(c.overlap, list.strength[p]) - (coheres ? coheres_by.pull_of(p) : 0.0);
      if constexpr (N::remembers) {  // not all that such a spring takes it gives back
        shot.normal_springs += normal.energy(c.overlap, list.stiffness[p], c.curvature, list.normal_memory[p]);
      } else {
        double none = 0;
        spring = normal.elastic(c.overlap, list.stiffness[p], c.curvature, none) + spring;
      }
      const Vec<D> dash = (dot(f, c.normal) - spring) * c.normal, slip = tangential(f, c.normal);
      shot.springs += friction.energy(s.laws.slip(c.sliding, sliding_stiffness(s, normal, p, c)), list.memory[p]);
      const Sharers<D> of{shot.disk[mover_of(s, s.record[list.i[p]].grain)],
                          list.j[p] >= 0 ? &shot.disk[mover_of(s, s.record[list.owner[p]].grain)] : nullptr};
      if (has_levers) {
        push_bodies(s, p, dash, slip, of);
      } else {
        push<D>(of.own, dash, slip, list.force[p].torque_i);
        if (of.partner) push<D>(*of.partner, -dash, -slip, list.force[p].torque_j);
      }
      if (wall_side(list.j[p]) >= sides_in<D>) add_boundary_contact(s, p, c, dash, slip, shot);
      else if (!of.partner) push_edges(wall_side(list.j[p]), dash, slip, shot);
      if (in_cell) add_to_cell(s, between_centres(s, p, c.branch), shears ? rows_of(s, p) : 0, f, dash, slip, shot);
    }
  });
}

/// Dashpots of bonds, and what bonds do to the shear of the cell.
template <int D> void add_bonds(const SampleIn<D>& s, ForcesAndRates<D>& shot) {
  const auto& bonds = the<BondsIn<D>>(s);
  for (std::size_t n = 0; n < bonds.slots.size(); ++n) {
    const BondSlotIn<D>& b = bonds.slots[n];
    if (b.state != BondState::holds) continue;
    const BeamMotionIn<D> m = beam_motion(s, b);
    const SlotForce<D> f = s.list.force[bonds.place(s.list, n)], dash = beam_slot_force(b, m, beam_dashpots(s, b, m));
    Load<D>&on_i = shot.disk[s.record[b.i].grain].dash, &on_j = shot.disk[s.record[b.j].grain].dash;
    on_i.force += dash.on_i;
    on_i.torque += dash.torque_i;
    on_j.force -= dash.on_i;
    on_j.torque += dash.torque_j;
    add_to_cell(s, m.branch, s.shear_rate != 0 ? b.shift.y : 0, f.on_i, dash.on_i, {}, shot);
  }
}

/// Nodes of membranes: those that a platen holds do its work, on all others the pressure works.
void add_nodes(const SampleIn<3>& /*sample*/, ForcesAndRates<3>& /*shot*/) {}
void add_nodes(const Sample& s, ForcesAndRates<2>& shot) {
  for (const Membrane& m : the<Membranes>(s).list)
    for (std::size_t k = 0; k < m.nodes(); ++k)
      for (const int axis : {0, 1}) {
        const double braked = m.own.braked[k][axis];
        shot.node.push_back({m.rate[k][axis], m.of_grains[k][axis] + m.own.pulled[k][axis] + braked, 0, 0,
                             m.own.pressed[k][axis], braked, m.is_free(k, axis)});
      }
}

template <int D> void add_boundaries(const SampleIn<D>& s, ForcesAndRates<D>& shot) {
  for (std::size_t b = 0; b < s.domain.boundaries.size(); ++b) {
    const BoundaryIn<D>& boundary = s.domain.boundaries[b];
    const BoundaryBodyIn<D>& body = the<BoundariesIn<D>>(s).body[b];
    const bool free = body.mass > 0;
    const auto rates = in_a_row(free ? body.rate : boundary.velocity, boundary.spin),
               forces = in_a_row(boundary.force, boundary.torque),
               drives = in_a_row(force_on(s, b) - boundary.force, Turning<D>{});
    for (std::size_t n = 0; n < rates.size(); ++n)
      shot.boundary.push_back({rates[n], forces[n], 0, 0, drives[n], 0, free && n < D});
  }
}

template <int D> void take_edges(const SampleIn<D>& s, bool corrects, ForcesAndRates<D>& shot) {
  for (int side = 0; side < sides_in<D>; ++side) {
    const WallIn<D>& wall = s.domain.wall[side];
    const WallDriveIn<D>& drive = s.wall[side].drive;
    const bool servo = drive.kind == DriveKind::force;
    const double rate = corrects ? wall_rate(s, side) : s.wall[side].rate,
                 pressed = servo ? inward_sign(side) * drive.value : 0.0;
    shot.edge[side] = {rate,    -inward_sign(side) * wall.force,       0,    0,
                       pressed, servo_braking(s, side, wall.velocity), servo};
    for (int n = 0; n < D - 1; ++n)
      shot.edge[shot.slides + side * (D - 1) + n] = {component(side, drive.slide, n),
                                                     wall.present ? component(side, wall.shear_force, n) : 0.0};
  }
  shot.edge[shot.cell_shear].rate = s.shear_rate * s.domain.extent(1);
}

}  // namespace

template <int D> ForcesAndRates<D> forces_and_rates(const SampleIn<D>& s) {
  ForcesAndRates<D> shot;
  shot.gravity = s.gravity;
  shot.disk.resize(s.count + body_count(s));
  const bool corrects = integrator_of(s).corrects();
  const CellMotion<D> cell = cell_motion(s.domain);
  each_mover(s, [&](std::size_t k) {
    const Mover<D> m = mover_at(s, k);
    auto& mover = shot.disk[k < s.count ? s.record[k].grain : k];
    mover.own = corrects ? motion_of(s, k) : m.own;
    if (is_held(s, k)) return;  // its wall carries its weight, and no drag brakes it
    mover.mass = m.mass;
    if (s.drag != 0) mover.drag = -s.drag * m.mass * (m.seen.velocity - cell.at(m.place));
  });
  take_edges(s, corrects, shot);
  add_boundaries(s, shot);
  add_nodes(s, shot);
  add_contacts(s, shot);
  add_bonds(s, shot);
  for (int axis = 0; axis < D; ++axis)
    if (s.domain.periodic[axis]) shot.edge[2 * axis + 1].push(-shot.edge[2 * axis].dash, -shot.edge[2 * axis].slip);
  return shot;
}

template ForcesAndRates<2> forces_and_rates(const SampleIn<2>&);
template ForcesAndRates<3> forces_and_rates(const SampleIn<3>&);

}  // namespace arenite::dem
