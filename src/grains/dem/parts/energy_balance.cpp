#include "grains/dem/parts/energy_balance.hpp"

#include <algorithm>
#include <utility>

#include "grains/dem/boundaries/elements.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/rolling.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

constexpr std::size_t slides = 4, cell_shear = 8;  // of ForcesAndRates::edge

/// What a contact with a boundary does to it, by class, about its centre as well.
void add_boundary_contact(const Sample& s, std::size_t slot, const Kinematics<2>& c, Vec2 dash, Vec2 slip,
                          ForcesAndRates& shot) {
  if (const TouchedSkin at = touched_skin(s, slot, c); at.of) {
    for (const auto& [node, share] : {std::pair{at.node, 1 - at.share}, std::pair{at.next, at.share}})
      for (const int axis : {0, 1})
        shot.node[2 * (at.of->first + node) + static_cast<std::size_t>(axis)].push(-share * dash[axis],
                                                                                   -share * slip[axis]);
    return;
  }
  const std::size_t b = boundary_index(s, s.list.j[slot]);
  const Vec2 arm = touched_place(s, slot, c) - s.domain.boundaries[b].centre;
  const double dashes[] = {dash.x, dash.y, cross(arm, dash)},
               slips[] = {slip.x, slip.y, cross(arm, slip) - s.list.force[slot].torque_j};
  for (std::size_t n = 0; n < 3; ++n) shot.boundary[3 * b + n].push(-dashes[n], -slips[n]);
}

/// Adds forces that act on a grain, with their torque about its centre.
void push(ForcesAndRates::Disk& grain, Vec2 dash, Vec2 slip, double torque) {
  grain.dash.force += dash;
  grain.slip.force += slip;
  grain.slip.torque += torque;
}

/// The same where they act at a lever from its centre, with their torque about that place.
void push(ForcesAndRates::Disk& grain, Vec2 dash, Vec2 slip, double torque, Vec2 lever) {
  push(grain, dash, slip, torque + cross(lever, slip));
  grain.dash.torque += cross(lever, dash);
}

/// What a contact or bond along `branch`, over so many rows of the periodic cell, does to its edges and its shear.
void add_to_cell(const Sample& s, Vec2 branch, int rows, Vec2 force, Vec2 dash, Vec2 slip, ForcesAndRates& shot) {
  shot.edge[cell_shear].force -= rows * force.x;
  shot.edge[cell_shear].push(-rows * dash.x, -rows * slip.x);
  for (const int axis : {0, 1})
    if (s.domain.periodic[axis]) {
      const double length = s.domain.extent(axis);
      shot.edge[2 * axis].push(-dash[axis] * branch[axis] / length, -slip[axis] * branch[axis] / length);
    }
}

void add_contacts(const Sample& s, ForcesAndRates& shot) {
  const ContactList& list = s.list;
  shot.springs = rolling_energy(s);
  // What disks in a box have none of is not looked for at each of their contacts.
  const bool has_levers = !has_disks_only(s), in_cell = s.domain.is_cell(), coheres = the<CohesivePairs>(s).remembers(),
             shears = s.shear_rate != 0;
  s.laws.visit([&]<class N, class A, class F>(const N& normal, const A& adhesion, const F& friction) {
    for (std::size_t p = 0; p < list.size(); ++p) {
      const Kinematics<2> c = p < list.pairs ? pair_kinematics(s.record[list.i[p]], s.record[list.j[p]], s.contact.arms)
                                             : slot_kinematics(s, p);
      if (shears && coheres && !(c.overlap > 0) && the<CohesivePairs>(s).pull_of(p) > 0)
        shot.edge[cell_shear].force -= rows_between(s, p) * list.force[p].on_i.x;
      if (!(c.overlap > 0)) continue;  // a clipped contact has no force, but its dashpot eats what its spring gives
      const Vec2 f = list.force[p].on_i, t = perpendicular(c.normal);
      double spring =
          -adhesion.attraction(c.overlap, list.strength[p]) - (coheres ? the<CohesivePairs>(s).pull_of(p) : 0.0);
      if constexpr (N::remembers) {  // not all that such a spring takes it gives back
        shot.normal_springs += normal.energy(c.overlap, list.stiffness[p], c.curvature, list.normal_memory[p]);
      } else {
        double none = 0;
        spring = normal.elastic(c.overlap, list.stiffness[p], c.curvature, none) + spring;
      }
      const Vec2 dash = (dot(f, c.normal) - spring) * c.normal, slip = dot(f, t) * t;
      shot.springs += friction.energy(s.laws.slip(c.sliding, sliding_stiffness(s, normal, p, c)), list.memory[p]);
      ForcesAndRates::Disk& own = shot.disk[mover_of(s, s.record[list.i[p]].grain)];
      ForcesAndRates::Disk* const partner =
          list.j[p] >= 0 ? &shot.disk[mover_of(s, s.record[list.owner[p]].grain)] : nullptr;
      if (has_levers) {
        const Levers<2> levers = levers_of(s, p);
        const Torques torques = own_torques(s, p);
        push(own, dash, slip, torques.i, levers.i);
        if (partner) push(*partner, -dash, -slip, torques.j, levers.j);
      } else {
        push(own, dash, slip, list.force[p].torque_i);
        if (partner) push(*partner, -dash, -slip, list.force[p].torque_j);
      }
      if (is_boundary(list.j[p])) {
        add_boundary_contact(s, p, c, dash, slip, shot);
      } else if (!partner) {
        const int side = wall_side(list.j[p]);
        shot.edge[side].push(-across(side, dash), 0);
        shot.edge[slides + side].push(0, -along(side, slip));
      }
      if (in_cell)
        add_to_cell(s, between_centres(s, p, c.branch), shears ? rows_between(s, p) : 0, f, dash, slip, shot);
    }
  });
}

/// Dashpots of bonds, and what bonds do to the shear of the cell.
void add_bonds(const Sample& s, ForcesAndRates& shot) {
  for (std::size_t n = 0; n < the<Bonds>(s).slots.size(); ++n) {
    const BondSlot& b = the<Bonds>(s).slots[n];
    if (b.state != BondSlot::State::holds) continue;
    const BeamMotion m = beam_motion(s, b);
    const SlotForce<2> f = s.list.force[the<Bonds>(s).place(s.list, n)],
                       dash = beam_slot_force(b, m, beam_dashpots(s, b, m));
    Load<2>&on_i = shot.disk[s.record[b.i].grain].dash, &on_j = shot.disk[s.record[b.j].grain].dash;
    on_i.force += dash.on_i;
    on_i.torque += dash.torque_i;
    on_j.force -= dash.on_i;
    on_j.torque += dash.torque_j;
    add_to_cell(s, m.branch, s.shear_rate != 0 ? b.shift.y : 0, f.on_i, dash.on_i, {}, shot);
  }
}

/// Nodes of membranes: those that a platen holds do its work, on all others the pressure works.
void add_nodes(const Sample& s, ForcesAndRates& shot) {
  for (const Membrane& m : the<Membranes>(s).list)
    for (std::size_t k = 0; k < m.nodes(); ++k)
      for (const int axis : {0, 1}) {
        const double braked = m.own.braked[k][axis];
        shot.node.push_back({m.rate[k][axis], m.of_grains[k][axis] + m.own.pulled[k][axis] + braked, 0, 0,
                             m.own.pressed[k][axis], braked, m.is_free(k, axis)});
      }
}

ForcesAndRates take(const Sample& s) {
  ForcesAndRates shot;
  shot.gravity = s.gravity;
  shot.disk.resize(s.count + the<Bodies>(s).body.size());
  const bool corrects = integrator_of(s).corrects();
  const CellMotion<2> cell = cell_motion(s.domain);
  each_mover(s, [&](std::size_t k) {
    const Mover m = mover_at(s, k);
    ForcesAndRates::Disk& mover = shot.disk[k < s.count ? s.record[k].grain : k];
    mover.own = corrects ? motion_of(s, k) : m.own;
    mover.mass = m.mass;
    if (s.drag != 0) mover.drag = -s.drag * m.mass * (m.seen.velocity - cell.at(m.place));
  });
  for (int side = 0; side < sides; ++side) {
    const Wall& wall = s.domain.wall[side];
    const WallDrive& drive = s.wall[side].drive;
    const bool servo = drive.kind == WallDrive::Kind::force;
    const double rate = corrects ? wall_rate(s, side) : s.wall[side].rate,
                 pressed = servo ? inward_sign(side) * drive.value : 0.0;
    shot.edge[side] = {rate,    -inward_sign(side) * wall.force,       0,    0,
                       pressed, servo_braking(s, side, wall.velocity), servo};
    shot.edge[slides + side] = {drive.slide, wall.present ? wall.shear_force : 0.0};
  }
  shot.edge[cell_shear].rate = s.shear_rate * s.domain.height();
  for (std::size_t b = 0; b < s.domain.boundaries.size(); ++b) {
    const Boundary& boundary = s.domain.boundaries[b];
    const bool free = the<Boundaries>(s).body[b].mass > 0;
    const Vec2 velocity = free ? the<Boundaries>(s).body[b].rate : boundary.velocity,
               push = force_on(s, b) - boundary.force;
    shot.boundary.push_back({velocity.x, boundary.force.x, 0, 0, push.x, 0, free});
    shot.boundary.push_back({velocity.y, boundary.force.y, 0, 0, push.y, 0, free});
    shot.boundary.push_back({boundary.spin, boundary.torque});
  }
  add_nodes(s, shot);
  add_contacts(s, shot);
  add_bonds(s, shot);
  for (const int low : {left, bottom})
    if (s.domain.is_periodic(low)) shot.edge[low + 1].push(-shot.edge[low].dash, -shot.edge[low].slip);
  return shot;
}

/// Sums of the mean force over the two times, times the velocities of the second.
WorkTerms products(const Sample& s, const ForcesAndRates& p, const ForcesAndRates& q) {
  WorkTerms w;
  const Vec2 gravity = p.gravity + q.gravity;
  for (std::size_t k = 0; k < q.disk.size(); ++k) {
    const auto &a = p.disk[k], &b = q.disk[k];
    const Vec2 velocity = 0.5 * b.own.velocity;
    w.dashpots += dot(a.dash.force + b.dash.force, velocity);
    w.friction += dot(a.slip.force + b.slip.force, velocity);
    if (s.integration.rotations) {
      w.dashpots += (a.dash.torque + b.dash.torque) * (0.5 * b.own.omega);
      w.friction += (a.slip.torque + b.slip.torque) * (0.5 * b.own.omega);
    }
    w.drag += dot(a.drag + b.drag, velocity);
    w.gravity += b.mass * dot(gravity, velocity);
  }
  const auto add_edge = [&w](const ForcesAndRates::Edge& a, const ForcesAndRates::Edge& b) {
    const double rate = 0.5 * b.rate;
    w.dashpots += (a.dash + b.dash) * rate;
    w.friction += (a.slip + b.slip) * rate;
    w.walls += b.servo ? (a.drive + b.drive) * rate : -(a.force + b.force) * rate;
    w.servo += (a.damping + b.damping) * rate;
  };
  for (std::size_t n = 0; n < q.edge.size(); ++n) add_edge(p.edge[n], q.edge[n]);
  for (std::size_t n = 0; n < q.boundary.size(); ++n) add_edge(p.boundary[n], q.boundary[n]);
  for (std::size_t n = 0; n < q.node.size(); ++n) add_edge(p.node[n], q.node[n]);
  return w;
}

void add(WorkTerms& sum, double factor, const WorkTerms& w) {
  for (const auto term : work_terms) sum.*term += factor * w.*term;
}

/// Work of the step from the powers at its end (`p`) and before.
WorkTerms integrate(const EnergyBalance& balance, const WorkTerms& p, double dt) {
  static constexpr double weight[3][4] = {{1, 1}, {5, 8, -1}, {9, 19, -5, 1}}, over[] = {2, 12, 24};
  const int order = std::clamp(balance.known, 1, 3);
  WorkTerms w;
  add(w, weight[order - 1][0] * dt / over[order - 1], p);
  for (int k = 1; k <= order; ++k) add(w, weight[order - 1][k] * dt / over[order - 1], balance.powers[k - 1]);
  return w;
}

}  // namespace

void EnergyBalance::begin(Sample& s) {
  if (open || !s.integration.track_energy) return;
  last = take(s);
  powers = {};
  add(powers[0], 1, products(s, last, last));
  known = 1;
  open = true;
}

void EnergyBalance::go_on(Sample& s) {
  if (!open) return;
  const auto stored = powers;
  const int number = known;
  open = false;
  begin(s);
  powers = stored;
  known = number;
}

void EnergyBalance::after_forces(Sample& s) {
  if (!s.integration.track_energy) return;
  ForcesAndRates now = take(s);
  WorkTerms work;
  if (integrator_of(s).corrects()) {
    WorkTerms power;
    add(power, 1, products(s, now, now));
    work = integrate(*this, power, s.dt);
    powers = {power, powers[0], powers[1]};
    known = known < 3 ? known + 1 : 3;
  } else {
    add(work, s.dt, products(s, last, now));
  }
  s.tally.dissipated_normal -= work.dashpots + (now.normal_springs - last.normal_springs);
  s.tally.dissipated_friction -= work.friction + (now.springs - last.springs);
  s.tally.dissipated_drag -= work.drag + work.servo;
  s.tally.work_gravity += work.gravity;
  s.tally.work_walls += work.walls;
  last = std::move(now);
}

}  // namespace arenite::dem
