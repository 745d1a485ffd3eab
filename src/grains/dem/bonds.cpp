#include "grains/dem/bonds.hpp"

#include <atomic>
#include <cmath>

#include "grains/dem/movers.hpp"
#include "grains/dem/setup.hpp"

namespace arenite::dem {

namespace {

using State = BondSlot::State;

/// Rate of the strain at these velocities of its two disks.
BeamStrain<double> strain_rate(const BondSlot& b, const BeamMotion& m, Vec2 velocity, double turning_i,
                               double turning_j) {
  return b.rate(dot(velocity, m.normal), cross(m.normal, velocity) / m.distance, turning_i, turning_j);
}

/// Energy that the sample loses with a bond. Half of its last step's work was still done by it, that of its force then
/// at the velocities before.
double energy_of_break(const Sample& s, const BondSlot& b, const BeamMotion& m, const BeamForce<double>& force,
                       double energy) {
  const BeamStrain<double> rate =
      strain_rate(b, m, velocity_beside(s, b.i, b.j, image_velocity(s, b.shift)), s.omega[b.i], s.omega[b.j]);
  return energy -
         time_behind(s) * (force.tension * rate.stretch + force.shear * rate.shear + force.moment * rate.bending);
}

void note_break(Sample& s, BondSlot& b, const BeamMotion& m, const BeamLoad& load, double energy) {
  Bond& bond = s.bonds[b.bond];
  b.state = State::breaking;
  bond.broken = load.kind;
  bond.load = load.share / b.strength;
  bond.energy = energy;
  bond.time = time_of(s);
  bond.place = s.record[b.i].place - (b.arm_i / b.length) * m.branch;
}

/// What broke in this step is booked in the order of bonds, whoever found it.
void book_breaks(Sample& s) {
  for (std::size_t n = 0; n < s.bond_slots.size(); ++n) {
    if (s.bond_slots[n].state != State::breaking) continue;
    end_bond(s, n);
    s.tally.dissipated_breakage += s.bonds[s.bond_slots[n].bond].energy;
  }
}

/// The periodic images that bonds mean, where they are now.
void move_images(Sample& s) {
  const BondRow<double*> column = s.bond_numbers.columns();
  for (const std::int32_t slot : s.bond_numbers.across) {
    const Vec2 place = s.domain.way(s.bond_slots[slot].shift), velocity = image_velocity(s, s.bond_slots[slot].shift);
    column.image.x[slot] = place.x;
    column.image.y[slot] = place.y;
    column.image_velocity.x[slot] = velocity.x;
    column.image_velocity.y[slot] = velocity.y;
  }
}

/// One bond, by the law itself. True if it breaks.
template <class Law> bool look_at(Sample& s, const Law& law, std::size_t n) {
  BondSlot& b = s.bond_slots[n];
  SlotForce<2>& force = s.list.force[bond_force_place(s.list, n)];
  force = {};
  if (b.state != State::holds) return false;
  const BeamMotion m = beam_motion(s, b);
  const BeamForce<double> f = law.elastic(b.beam, m.strain);
  if (const BeamLoad load = law.load(b.beam, f); load.share >= b.strength) {
    note_break(s, b, m, load, energy_of_break(s, b, m, f, law.energy(b.beam, m.strain)));
    return true;
  }
  force = beam_slot_force(b, m, f + beam_dashpots(s, b, m));
  return false;
}

BondTask bond_task(Sample& s) {
  BondNumbers& numbers = s.bond_numbers;
  const auto column = std::bit_cast<BondRow<const double*>>(numbers.columns());
  return {s.record.data(),
          s.angle.along[0].data(),
          numbers.i.data(),
          numbers.j.data(),
          column,
          &s.list.force[bond_force_place(s.list, 0)],
          numbers.look.data(),
          numbers.damped};
}

}  // namespace

BeamMotion beam_motion(const Sample& s, const BondSlot& b) {
  BeamMotion m;
  m.branch = s.record[b.i].place - s.record[b.j].place - s.domain.way(b.shift);
  m.distance = norm(m.branch);
  m.normal = m.branch / m.distance;
  const double turned = std::atan2(cross(b.normal, m.normal), dot(b.normal, m.normal));
  const double turn_i = s.angle[b.i] - b.angle_i - turned, turn_j = s.angle[b.j] - b.angle_j - turned;
  m.strain = b.strain(m.distance, turn_i, turn_j);
  return m;
}

SlotForce<2> beam_slot_force(const BondSlot& b, const BeamMotion& m, const BeamForce<double>& f) {
  const auto [on_i, torque_i, torque_j] = b.pull(f, m.normal, f.shear * b.length / m.distance);
  return {on_i, torque_i, torque_j};
}

BeamForce<double> beam_dashpots(const Sample& s, const BondSlot& b, const BeamMotion& m) {
  const DiskRecord &a = s.record[b.i], &c = s.record[b.j];
  return b.dashpots.force(strain_rate(b, m, a.velocity - c.velocity - image_velocity(s, b.shift), a.omega, c.omega));
}

void add_bond_forces(Sample& s, const ThreadPool& pool) {
  if (s.bond_slots.empty()) return;
  move_images(s);
  const BondTask task = bond_task(s);
  const Kernel::BondLoop loop = s.kernel->bond_loops[s.contact.bonds.index()];
  std::atomic<bool> broke = false;
  s.contact.bonds.visit([&](const auto& law) {
    pool.for_ranges(s.bond_slots.size(), [&](std::size_t begin, std::size_t end) {
      if (!loop(task, s.contact.bonds, begin, end)) return;
      for (std::size_t n = begin; n < end; ++n)
        if (task.look[n] != 0 && look_at(s, law, n)) broke = true;
    });
  });
  if (broke) book_breaks(s);
}

std::vector<Bond> bonds_of(const Sample& s) {
  std::vector<Bond> bonds = s.bonds;
  s.contact.bonds.visit([&](const auto& law) {
    for (const BondSlot& b : s.bond_slots) {
      if (b.state != State::holds) continue;
      const BeamMotion m = beam_motion(s, b);
      const BeamForce<double> f = law.elastic(b.beam, m.strain);
      Bond& bond = bonds[b.bond];
      bond.fn = -f.tension;
      bond.ft = f.shear * b.length / m.distance;
      bond.moment = -f.moment;
      bond.energy = law.energy(b.beam, m.strain);
      bond.load = law.load(b.beam, f).share / b.strength;
    }
  });
  return bonds;
}

double bond_energy(const Sample& s) {
  double sum = 0;
  s.contact.bonds.visit([&](const auto& law) {
    for (const BondSlot& b : s.bond_slots)
      if (b.state == State::holds) sum += law.energy(b.beam, beam_motion(s, b).strain);
  });
  return sum;
}

}  // namespace arenite::dem
