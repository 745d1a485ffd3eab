#include "grains/dem/bonds.hpp"

#include <atomic>
#include <cmath>
#include <numbers>

#include "grains/dem/setup.hpp"

namespace arenite::dem {
namespace {

using State = BondSlot::State;

/// Where the image of j that a bond means is away from j, and how fast it moves beside it.
Vec2 image_place(const Sample& s, const BondSlot& b) { return {b.shift_x * s.domain.width() + b.shift_y * s.domain.tilt, b.shift_y * s.domain.height()}; }
Vec2 image_velocity(const Sample& s, const BondSlot& b) {
  const auto& w = s.domain.wall;
  const double stretch_x = s.domain.periodic_x ? w[right].velocity - w[left].velocity : 0;
  const double stretch_y = s.domain.periodic_y ? w[top].velocity - w[bottom].velocity : 0;
  return {b.shift_x * stretch_x + b.shift_y * (s.domain.tilt * stretch_x / s.domain.width() + s.shear_rate * s.domain.height()), b.shift_y * stretch_y};
}

/// The angle of this sine and cosine. Bonds turn little, so nearly always the arc sine's series does, to the last bit.
double angle_of(double sine, double cosine) {
  if (!(std::abs(sine) < 0.05 && cosine > 0)) return std::atan2(sine, cosine);
  const double q = sine * sine;
  return sine * (1 + q * (1.0 / 6 + q * (3.0 / 40 + q * (15.0 / 336 + q * (105.0 / 3456 + q * (945.0 / 42240))))));
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

BeamMotion beam_motion(const Sample& s, const BondSlot& b) {
  const auto i = static_cast<std::size_t>(b.i), j = static_cast<std::size_t>(b.j);
  const DiskRecord &a = s.record[i], &c = s.record[j];
  const Vec2 place = image_place(s, b), velocity = image_velocity(s, b);
  BeamMotion m;
  m.branch = {a.x - c.x - place.x, a.y - c.y - place.y};
  m.distance = norm(m.branch);
  m.normal = m.branch / m.distance;
  const double turned = angle_of(cross(b.normal, m.normal), dot(b.normal, m.normal));
  const double turn_i = within_half_turn(s.angle[i] - b.angle_i - turned), turn_j = within_half_turn(s.angle[j] - b.angle_j - turned);
  m.strain = {m.distance - b.length, b.arm_i * turn_i + b.arm_j * turn_j, turn_i - turn_j};
  m.rate = strain_rate(b, m, {a.vx - c.vx - velocity.x, a.vy - c.vy - velocity.y}, a.omega, c.omega);
  return m;
}

SlotForce beam_slot_force(const BondSlot& b, const BeamMotion& m, const BeamForce& f) {
  const double across = f.shear * b.length / m.distance;
  return {-f.tension * m.normal.x - across * m.normal.y, -f.tension * m.normal.y + across * m.normal.x, -f.shear * b.arm_i - f.moment,
          -f.shear * b.arm_j + f.moment};
}

SlotForce beam_dashpots(const BondSlot& b, const BeamMotion& m) {
  return beam_slot_force(b, m, {b.normal_damping * m.rate.stretch, b.shear_damping * m.rate.shear, b.bending_damping * m.rate.bending});
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
            const BeamMotion m = beam_motion(s, b);
            BeamForce f = law.elastic(b.beam, m.strain);
            if (const BeamLoad load = law.load(b.beam, f); load.share >= b.strength) {
              note_break(s, b, m, load, energy_of_break(s, b, m, f, law.energy(b.beam, m.strain)));
              broke = true;
              continue;
            }
            f.tension += b.normal_damping * m.rate.stretch;
            f.shear += b.shear_damping * m.rate.shear;
            f.moment += b.bending_damping * m.rate.bending;
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
