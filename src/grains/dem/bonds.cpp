#include "grains/dem/bonds.hpp"

#include <atomic>
#include <cmath>
#include <numbers>

#include "grains/dem/setup.hpp"

namespace arenite::dem {

Vec2 image_place(const Sample& s, const BondSlot& b) {
  if ((b.shift_x | b.shift_y) == 0) return {};
  return {b.shift_x * s.domain.width() + b.shift_y * s.domain.tilt, b.shift_y * s.domain.height()};
}

namespace {

using State = BondSlot::State;

/// How fast that image moves beside j.
Vec2 image_velocity(const Sample& s, const BondSlot& b) {
  if ((b.shift_x | b.shift_y) == 0) return {};
  const auto& w = s.domain.wall;
  const double stretch_x = s.domain.periodic_x ? w[right].velocity - w[left].velocity : 0;
  const double stretch_y = s.domain.periodic_y ? w[top].velocity - w[bottom].velocity : 0;
  return {b.shift_x * stretch_x + b.shift_y * (s.domain.tilt * stretch_x / s.domain.width() + s.shear_rate * s.domain.height()), b.shift_y * stretch_y};
}

/// The angle of this sine and cosine. Since the list was built a bond has turned little, and the arc sine's series does to the last bit.
double angle_of(double sine, double cosine) {
  if (!(std::abs(sine) < 0.15 && cosine > 0)) return std::atan2(sine, cosine);
  constexpr double terms[] = {135135.0 / 9676800, 10395.0 / 599040, 945.0 / 42240, 105.0 / 3456, 15.0 / 336, 3.0 / 40, 1.0 / 6, 1.0};
  const double q = sine * sine;
  double sum = 2027025.0 / 175472640;
  for (const double term : terms) sum = sum * q + term;
  return sine * sum;
}

double within_half_turn(double angle) {
  constexpr double turn = 2 * std::numbers::pi;
  return std::abs(angle) < 0.5 * turn ? angle : angle - turn * std::nearbyint(angle / turn);
}

/// Rate of the strain at these velocities of its two disks.
BeamStrain strain_rate(const BondSlot& b, const BeamMotion& m, Vec2 velocity, double turning_i, double turning_j) {
  const double across = dot(velocity, perpendicular(m.normal)) / m.distance;
  return {dot(velocity, m.normal), b.arm_i * turning_i + b.arm_j * turning_j - b.length * across, turning_i - turning_j};
}

/// Part of the loop over the bonds, and a call there would cost a quarter of it.
[[gnu::always_inline]] inline BeamMotion motion_of_beam(const Sample& s, const BondSlot& b) {
  const auto i = static_cast<std::size_t>(b.i), j = static_cast<std::size_t>(b.j);
  const DiskRecord &a = s.record[i], &c = s.record[j];
  const Vec2 place = image_place(s, b);
  BeamMotion m;
  m.branch = {a.x - c.x - place.x, a.y - c.y - place.y};
  m.distance = norm(m.branch);
  m.normal = (1 / m.distance) * m.branch;
  const double turned = b.turned + angle_of(cross(b.normal, m.normal), dot(b.normal, m.normal));
  const double turn_i = within_half_turn(s.angle[i] - b.angle_i - turned), turn_j = within_half_turn(s.angle[j] - b.angle_j - turned);
  m.strain = {m.distance - b.length, b.arm_i * turn_i + b.arm_j * turn_j, turn_i - turn_j};
  return m;
}

/// Energy that the sample loses with a bond. Half of its last step's work was still done by it, that of its force then at the velocities before.
double energy_of_break(const Sample& s, const BondSlot& b, const BeamMotion& m, const BeamForce& force, double energy) {
  const bool gear = s.integration.integrator == IntegratorKind::gear5;
  const double since = gear ? (s.settled ? 0.5 * s.dt : 0.0) : s.lag;
  const auto i = static_cast<std::size_t>(b.i), j = static_cast<std::size_t>(b.j);
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  const Vec2 image = image_velocity(s, b);
  const Vec2 v{s.vx[i] + mx.at(s.record[i].x) - s.vx[j] - mx.at(s.record[j].x) - image.x,
               s.vy[i] + my.at(s.record[i].y) - s.vy[j] - my.at(s.record[j].y) - image.y};
  const BeamStrain rate = strain_rate(b, m, v, s.omega[i], s.omega[j]);
  return energy - since * (force.tension * rate.stretch + force.shear * rate.shear + force.moment * rate.bending);
}

void note_break(Sample& s, BondSlot& b, const BeamMotion& m, const BeamLoad& load, double energy) {
  Bond& bond = s.bonds[static_cast<std::size_t>(b.bond)];
  const DiskRecord& a = s.record[static_cast<std::size_t>(b.i)];
  b.state = State::breaking;
  bond.broken = load.kind;
  bond.load = load.share / b.strength;
  bond.energy = energy;
  bond.time = time_of(s);
  bond.place = Vec2{a.x, a.y} - (b.arm_i / b.length) * m.branch;
}

/// What broke in this step is booked in the order of bonds, whoever found it.
void book_breaks(Sample& s) {
  for (BondSlot& b : s.bond_slots) {
    if (b.state != State::breaking) continue;
    b.state = State::broken;
    s.tally.dissipated_breakage += s.bonds[static_cast<std::size_t>(b.bond)].energy;
  }
}

}  // namespace

BeamMotion beam_motion(const Sample& s, const BondSlot& b) { return motion_of_beam(s, b); }

SlotForce beam_slot_force(const BondSlot& b, const BeamMotion& m, const BeamForce& f) {
  const double across = f.shear * b.length / m.distance;
  return {-f.tension * m.normal.x - across * m.normal.y, -f.tension * m.normal.y + across * m.normal.x, -f.shear * b.arm_i - f.moment,
          -f.shear * b.arm_j + f.moment};
}

BeamForce beam_dashpots(const Sample& s, const BondSlot& b, const BeamMotion& m) {
  const DiskRecord &a = s.record[static_cast<std::size_t>(b.i)], &c = s.record[static_cast<std::size_t>(b.j)];
  const BeamStrain rate = strain_rate(b, m, Vec2{a.vx - c.vx, a.vy - c.vy} - image_velocity(s, b), a.omega, c.omega);
  return {b.normal_damping * rate.stretch, b.shear_damping * rate.shear, b.bending_damping * rate.bending};
}

void add_bond_forces(Sample& s, const Team& team) {
  if (s.bond_slots.empty()) return;
  std::atomic<bool> broke = false;
  std::visit(
      [&](const auto& law) {
        team.for_ranges(s.bond_slots.size(), [&](std::size_t begin, std::size_t end) {
          for (std::size_t n = begin; n < end; ++n) {
            BondSlot& b = s.bond_slots[n];
            SlotForce& force = s.list.force[bond_force_place(s.list, n)];
            force = {};
            if (b.state != State::holds) continue;
            const BeamMotion m = motion_of_beam(s, b);
            BeamForce f = law.elastic(b.beam, m.strain);
            if (const BeamLoad load = law.load(b.beam, f); load.share >= b.strength) {
              note_break(s, b, m, load, energy_of_break(s, b, m, f, law.energy(b.beam, m.strain)));
              broke = true;
              continue;
            }
            if (b.normal_damping > 0) {
              const BeamForce dash = beam_dashpots(s, b, m);
              f = {f.tension + dash.tension, f.shear + dash.shear, f.moment + dash.moment};
            }
            force = beam_slot_force(b, m, f);
          }
        });
      },
      s.contact.bonds);
  if (broke) book_breaks(s);
}

std::vector<Bond> bonds_of(const Sample& s) {
  std::vector<Bond> bonds = s.bonds;
  std::visit(
      [&](const auto& law) {
        for (const BondSlot& b : s.bond_slots) {
          if (b.state != State::holds) continue;
          const BeamMotion m = beam_motion(s, b);
          const BeamForce f = law.elastic(b.beam, m.strain);
          Bond& bond = bonds[static_cast<std::size_t>(b.bond)];
          bond.fn = -f.tension;
          bond.ft = f.shear * b.length / m.distance;
          bond.moment = -f.moment;
          bond.energy = law.energy(b.beam, m.strain);
          bond.load = law.load(b.beam, f).share / b.strength;
        }
      },
      s.contact.bonds);
  return bonds;
}

double bond_energy(const Sample& s) {
  double sum = 0;
  std::visit(
      [&](const auto& law) {
        for (const BondSlot& b : s.bond_slots)
          if (b.state == State::holds) sum += law.energy(b.beam, beam_motion(s, b).strain);
      },
      s.contact.bonds);
  return sum;
}

}  // namespace arenite::dem
