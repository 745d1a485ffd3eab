#include "dem/forces.hpp"

#include <algorithm>
#include <limits>

#include "dem/kinematics.hpp"

namespace arenite::dem {

namespace {

/// Ends the bonds that break for good where their contact has opened; the energy of the tangential spring is lost.
template <class F>
void end_open_bonds(Sample& s, const F& friction) {
  for (std::size_t p = 0; p < s.list.pairs; ++p) {
    if (!(s.list.strength[p] > 0)) continue;
    auto& bond = s.list.bond[p];
    if (slot_kinematics(s, p).overlap > 0) {
      bond = touching;
    } else if (bond == touching) {
      bond = never_touched;
      s.list.strength[p] = 0;
      s.live_bonds.erase(std::lower_bound(s.live_bonds.begin(), s.live_bonds.end(), slot_key(s, p)));
      const double lost = friction.energy(0.0, s.list.stiffness[p], s.list.memory[p]);
      s.tally.dissipated_breakage += lost;
      s.tally.dissipated_friction -= lost;
    }
  }
}

template <class N, class A, class F>
void evaluate(Sample& s, const N& normal, const A& adhesion, const F& friction) {
  ContactList& list = s.list;
  const double floor = s.contact.attractive_dashpot ? -std::numeric_limits<double>::infinity() : 0.0;
  for (std::size_t p = 0; p < list.size(); ++p) {
    const Kinematics c = slot_kinematics(s, p);
    if (!(c.overlap > 0)) {
      list.fx[p] = list.fy[p] = list.torque_i[p] = list.torque_j[p] = list.memory[p] = 0;
      continue;
    }
    const double mu = list.j[p] < 0 ? s.wall_friction : s.friction;
    const ContactState<double> state{c.overlap, c.approach, c.sliding, c.curvature, list.stiffness[p], list.damping[p],
                                     list.viscosity[p], list.strength[p], mu,
                                     list.strength[p] > 0 ? -std::numeric_limits<double>::infinity() : floor};
    const ContactForce<double> f = contact_force(normal, adhesion, friction, state, list.memory[p]);
    list.fx[p] = f.normal * c.normal.x - f.tangential * c.normal.y;
    list.fy[p] = f.normal * c.normal.y + f.tangential * c.normal.x;
    list.torque_i[p] = -c.arm_i * f.tangential;
    list.torque_j[p] = -c.arm_j * f.tangential;
  }
}

/// The force that the grains exert on a wall is the opposite of the wall's on them; on a periodic edge it is the mean
/// over all cuts of the cell, (1/W) sum f_x l_x.
void sum_wall_forces(Sample& s) {
  const ContactList& list = s.list;
  for (auto& wall : s.domain.wall) wall.force = wall.shear_force = 0;
  for (std::size_t p = list.pairs; p < list.size(); ++p) {
    const int side = -1 - list.j[p];
    Wall& wall = s.domain.wall[static_cast<std::size_t>(side)];
    const Vec2 n = inward_normal(side);
    wall.force += list.fx[p] * n.x + list.fy[p] * n.y;
    wall.shear_force -= side < bottom ? list.fy[p] : list.fx[p];
  }
  if (!s.domain.periodic_x && !s.domain.periodic_y) return;
  double xx = 0, yy = 0, xy = 0, yx = 0;
  const auto branch = [&](std::size_t p) {
    const auto& a = s.record[static_cast<std::size_t>(list.i[p])];
    if (list.j[p] < 0) return slot_kinematics(s, p).branch;
    const auto& b = s.record[static_cast<std::size_t>(list.j[p])];
    return Vec2{a.x - b.x, a.y - b.y};
  };
  for (std::size_t p = 0; p < list.size(); ++p) {
    if (list.fx[p] == 0 && list.fy[p] == 0) continue;
    const Vec2 l = branch(p);
    xx += list.fx[p] * l.x;
    yy += list.fy[p] * l.y;
    xy += list.fy[p] * l.x;
    yx += list.fx[p] * l.y;
  }
  auto& w = s.domain.wall;
  if (s.domain.periodic_x) {
    w[left].force = w[right].force = xx / s.domain.width();
    w[left].shear_force = -xy / s.domain.width();
    w[right].shear_force = xy / s.domain.width();
  }
  if (s.domain.periodic_y) {
    w[bottom].force = w[top].force = yy / s.domain.height();
    w[bottom].shear_force = -yx / s.domain.height();
    w[top].shear_force = yx / s.domain.height();
  }
}

}  // namespace

void compute_forces(Sample& s) {
  std::visit([&](const auto& normal, const auto& adhesion, const auto& friction) {
    if (!s.live_bonds.empty()) end_open_bonds(s, friction);
    evaluate(s, normal, adhesion, friction);
  }, s.laws.normal, s.laws.adhesion, s.laws.friction);
  sum_wall_forces(s);
}

}  // namespace arenite::dem
