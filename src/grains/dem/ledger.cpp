#include "grains/dem/ledger.hpp"

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/cohesion.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/sample.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

constexpr std::size_t along = 4, cell_shear = 8;  // of Snapshot::edge

/// What a contact with a boundary does to it, by class, about its centre as well.
void add_boundary_contact(const Sample& s, std::size_t slot, const Kinematics& c, Vec2 dash, Vec2 slip, Snapshot& shot) {
  const std::size_t b = boundary_index(s, s.list.j[slot]);
  const Vec2 arm = touched_place(s, slot, c) - s.domain.boundaries[b].centre;
  auto* edge = &shot.boundary[3 * b];
  edge[0].dash -= dash.x;
  edge[1].dash -= dash.y;
  edge[2].dash -= cross(arm, dash);
  edge[0].slip -= slip.x;
  edge[1].slip -= slip.y;
  edge[2].slip += s.list.force[slot].torque_j - cross(arm, slip);
}

/// Moments of a disk's forces about the centre of its body.
void add_about_body(Vec2 lever, Vec2 dash, Vec2 slip, Snapshot::Disk& body) {
  body.dash_torque += cross(lever, dash);
  body.slip_torque += cross(lever, slip);
}

void add_contacts(const Sample& s, Snapshot& shot) {
  const ContactList& list = s.list;
  const double width = s.domain.width(), height = s.domain.height();
  shot.springs = rolling_energy(s);
  s.laws.visit([&]<class N, class A, class F>(const N& normal, const A& adhesion, const F& friction) {
    for (std::size_t p = 0; p < list.size(); ++p) {
      const Kinematics c = slot_kinematics(s, p);
      if (s.shear_rate != 0 && !(c.overlap > 0) && pull_of(s, p) > 0) shot.edge[cell_shear].force -= rows_between(s, p) * list.force[p].fx;
      if (!(c.overlap > 0)) continue;  // a clipped contact has no force, but its dashpot eats what its spring gives
      const Vec2 f{list.force[p].fx, list.force[p].fy}, t = perpendicular(c.normal);
      double spring = -adhesion.attraction(c.overlap, list.strength[p]) - pull_of(s, p);
      if constexpr (N::remembers) {  // not all that such a spring takes it gives back
        shot.normal_springs += normal.energy(c.overlap, list.stiffness[p], c.curvature, list.normal_memory[p]);
      } else {
        double none = 0;
        spring = normal.elastic(c.overlap, list.stiffness[p], c.curvature, none) + spring;
      }
      const Vec2 dash = (dot(f, c.normal) - spring) * c.normal, slip = dot(f, t) * t;
      shot.springs += friction.energy(s.laws.slip(c.sliding, sliding_stiffness(s, normal, p, c)), list.memory[p]);
      const std::int32_t first = s.record[static_cast<std::size_t>(list.i[p])].grain;
      auto& a = shot.disk[mover_of(s, first)];
      add_about_body(own_lever(s, p), dash, slip, a);
      a.dash_x += dash.x;
      a.dash_y += dash.y;
      a.slip_x += slip.x;
      a.slip_y += slip.y;
      a.slip_torque += own_torque_i(s, p);
      if (list.j[p] >= 0) {
        auto& b = shot.disk[mover_of(s, s.record[static_cast<std::size_t>(list.owner[p])].grain)];
        add_about_body(partner_lever(s, p), -dash, -slip, b);
        b.dash_x -= dash.x;
        b.dash_y -= dash.y;
        b.slip_x -= slip.x;
        b.slip_y -= slip.y;
        b.slip_torque += own_torque_j(s, p);
      } else if (is_boundary(list.j[p])) {
        add_boundary_contact(s, p, c, dash, slip, shot);
      } else {
        const auto side = static_cast<std::size_t>(wall_side(list.j[p]));
        shot.edge[side].dash -= side < bottom ? dash.x : dash.y;
        shot.edge[along + side].slip -= side < bottom ? slip.y : slip.x;
      }
      if (const int images = s.shear_rate != 0 ? rows_between(s, p) : 0; images != 0) {
        shot.edge[cell_shear].force -= images * f.x;
        shot.edge[cell_shear].dash -= images * dash.x;
        shot.edge[cell_shear].slip -= images * slip.x;
      }
      const Vec2 branch = between_centres(s, p, c.branch);
      if (s.domain.periodic_x) {
        shot.edge[left].dash -= dash.x * branch.x / width;
        shot.edge[left].slip -= slip.x * branch.x / width;
      }
      if (s.domain.periodic_y) {
        shot.edge[bottom].dash -= dash.y * branch.y / height;
        shot.edge[bottom].slip -= slip.y * branch.y / height;
      }
    }
  });
}

/// Dashpots of bonds, and what bonds do to the shear of the cell.
void add_bonds(const Sample& s, Snapshot& shot) {
  for (std::size_t n = 0; n < s.bond_slots.size(); ++n) {
    const BondSlot& b = s.bond_slots[n];
    if (b.state != BondSlot::State::holds) continue;
    const BeamMotion m = beam_motion(s, b);
    const SlotForce dash = beam_slot_force(b, m, beam_dashpots(s, b, m));
    auto& disk_i = shot.disk[static_cast<std::size_t>(s.record[static_cast<std::size_t>(b.i)].grain)];
    disk_i.dash_x += dash.fx;
    disk_i.dash_y += dash.fy;
    disk_i.dash_torque += dash.torque_i;
    auto& disk_j = shot.disk[static_cast<std::size_t>(s.record[static_cast<std::size_t>(b.j)].grain)];
    disk_j.dash_x -= dash.fx;
    disk_j.dash_y -= dash.fy;
    disk_j.dash_torque += dash.torque_j;
    if (s.shear_rate != 0) {
      shot.edge[cell_shear].force -= b.shift_y * s.list.force[bond_force_place(s.list, n)].fx;
      shot.edge[cell_shear].dash -= b.shift_y * dash.fx;
    }
    if (s.domain.periodic_x) shot.edge[left].dash -= dash.fx * m.branch.x / s.domain.width();
    if (s.domain.periodic_y) shot.edge[bottom].dash -= dash.fy * m.branch.y / s.domain.height();
  }
}

Snapshot take(const Sample& s) {
  Snapshot shot;
  shot.gravity = s.gravity;
  shot.disk.resize(s.count + s.body.size());
  shot.boundary.resize(3 * s.domain.boundaries.size());
  const bool corrects = integrator_of(s).corrects();
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  for (std::size_t k = 0; k < s.count; ++k) {
    const DiskRecord& d = s.record[k];
    if (is_part(s, k)) continue;
    const Motion v = corrects ? motion_of(s, k) : Motion{s.vx[k], s.vy[k], s.omega[k]};
    auto& disk = shot.disk[static_cast<std::size_t>(d.grain)];
    disk.vx = v.vx;
    disk.vy = v.vy;
    disk.omega = v.omega;
    disk.mass = d.mass;
    disk.drag_x = -s.drag * d.mass * (d.vx - mx.at(d.x));
    disk.drag_y = -s.drag * d.mass * (d.vy - my.at(d.y));
  }
  for (std::size_t n = 0; n < s.body.size(); ++n) {
    const Body& b = s.body[n];
    auto& disk = shot.disk[s.count + n];
    disk.vx = b.vx;
    disk.vy = b.vy;
    disk.omega = b.omega;
    disk.mass = b.mass;
    disk.drag_x = -s.drag * b.mass * (b.seen_x - mx.at(b.x));
    disk.drag_y = -s.drag * b.mass * (b.seen_y - my.at(b.y));
  }
  add_contacts(s, shot);
  add_bonds(s, shot);
  if (s.domain.periodic_x) {
    shot.edge[right].dash = -shot.edge[left].dash;
    shot.edge[right].slip = -shot.edge[left].slip;
  }
  if (s.domain.periodic_y) {
    shot.edge[top].dash = -shot.edge[bottom].dash;
    shot.edge[top].slip = -shot.edge[bottom].slip;
  }
  for (std::size_t side = 0; side < 4; ++side) {
    auto& edge = shot.edge[side];
    edge.rate = corrects ? wall_rate(s, side) : s.wall[side].rate;
    edge.force = -inward_sign(side) * s.domain.wall[side].force;
    edge.servo = s.wall[side].drive.kind == WallDrive::Kind::force;
    if (edge.servo) {
      edge.drive = inward_sign(side) * s.wall[side].drive.value;
      edge.damping = servo_braking(s, side, s.domain.wall[side].velocity);
    }
    shot.edge[along + side].rate = s.wall[side].drive.slide;
    shot.edge[along + side].force = s.domain.wall[side].present ? s.domain.wall[side].shear_force : 0.0;
  }
  for (std::size_t b = 0; b < s.domain.boundaries.size(); ++b) {
    const Boundary& boundary = s.domain.boundaries[b];
    const bool free = s.boundary[b].mass > 0;
    const Vec2 velocity = free ? s.boundary[b].rate : boundary.velocity, push = force_on(s, b) - boundary.force;
    const double rate[] = {velocity.x, velocity.y, boundary.spin}, force[] = {boundary.force.x, boundary.force.y, boundary.torque};
    for (std::size_t n = 0; n < 3; ++n) {
      shot.boundary[3 * b + n].rate = rate[n];
      shot.boundary[3 * b + n].force = force[n];
      shot.boundary[3 * b + n].servo = free && n < 2;
    }
    shot.boundary[3 * b].drive = push.x;
    shot.boundary[3 * b + 1].drive = push.y;
  }
  shot.edge[cell_shear].rate = s.shear_rate * s.domain.height();
  return shot;
}

/// Sums of the mean force over the two times, times the velocities of the second.
WorkTerms products(const Sample& s, const Snapshot& p, const Snapshot& q) {
  WorkTerms w;
  const Vec2 gravity = p.gravity + q.gravity;
  for (std::size_t k = 0; k < q.disk.size(); ++k) {
    const auto &a = p.disk[k], &b = q.disk[k];
    const double vx = 0.5 * b.vx, vy = 0.5 * b.vy, omega = 0.5 * b.omega;
    w.dashpots += (a.dash_x + b.dash_x) * vx + (a.dash_y + b.dash_y) * vy;
    w.friction += (a.slip_x + b.slip_x) * vx + (a.slip_y + b.slip_y) * vy;
    if (s.integration.rotations) {
      w.dashpots += (a.dash_torque + b.dash_torque) * omega;
      w.friction += (a.slip_torque + b.slip_torque) * omega;
    }
    w.drag += (a.drag_x + b.drag_x) * vx + (a.drag_y + b.drag_y) * vy;
    w.gravity += b.mass * (gravity.x * vx + gravity.y * vy);
  }
  const auto add_edge = [&w](const Snapshot::Edge& a, const Snapshot::Edge& b) {
    const double rate = 0.5 * b.rate;
    w.dashpots += (a.dash + b.dash) * rate;
    w.friction += (a.slip + b.slip) * rate;
    w.walls += b.servo ? (a.drive + b.drive) * rate : -(a.force + b.force) * rate;
    w.servo += (a.damping + b.damping) * rate;
  };
  for (std::size_t n = 0; n < q.edge.size(); ++n) add_edge(p.edge[n], q.edge[n]);
  for (std::size_t n = 0; n < q.boundary.size(); ++n) add_edge(p.boundary[n], q.boundary[n]);
  return w;
}

void add(WorkTerms& sum, double factor, const WorkTerms& w) {
  sum.dashpots += factor * w.dashpots;
  sum.friction += factor * w.friction;
  sum.drag += factor * w.drag;
  sum.gravity += factor * w.gravity;
  sum.walls += factor * w.walls;
  sum.servo += factor * w.servo;
}

/// Work of the step from the powers at its end (`p`) and before.
WorkTerms integrate(const Ledger& ledger, const WorkTerms& p, double dt) {
  WorkTerms w;
  if (ledger.known >= 3) {
    add(w, 9 * dt / 24, p);
    add(w, 19 * dt / 24, ledger.powers[0]);
    add(w, -5 * dt / 24, ledger.powers[1]);
    add(w, dt / 24, ledger.powers[2]);
  } else if (ledger.known == 2) {
    add(w, 5 * dt / 12, p);
    add(w, 8 * dt / 12, ledger.powers[0]);
    add(w, -dt / 12, ledger.powers[1]);
  } else {
    add(w, dt / 2, p);
    add(w, dt / 2, ledger.powers[0]);
  }
  return w;
}

}  // namespace

void open_ledger(Sample& s) {
  Ledger& ledger = s.ledger;
  ledger.last = take(s);
  ledger.powers = {};
  add(ledger.powers[0], 1, products(s, ledger.last, ledger.last));
  ledger.known = 1;
  ledger.open = true;
}

void book_step(Sample& s) {
  Ledger& ledger = s.ledger;
  Snapshot now = take(s);
  WorkTerms work;
  if (integrator_of(s).corrects()) {
    WorkTerms power;
    add(power, 1, products(s, now, now));
    work = integrate(ledger, power, s.dt);
    ledger.powers = {power, ledger.powers[0], ledger.powers[1]};
    ledger.known = ledger.known < 3 ? ledger.known + 1 : 3;
  } else {
    add(work, s.dt, products(s, ledger.last, now));
  }
  s.tally.dissipated_normal -= work.dashpots + (now.normal_springs - ledger.last.normal_springs);
  s.tally.dissipated_friction -= work.friction + (now.springs - ledger.last.springs);
  s.tally.dissipated_drag -= work.drag + work.servo;
  s.tally.work_gravity += work.gravity;
  s.tally.work_walls += work.walls;
  ledger.last = std::move(now);
}

}  // namespace arenite::dem
