#include "grains/dem/parts/bonds.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"

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
  Bond& bond = the<Bonds>(s).all[b.bond];
  b.state = State::breaking;
  bond.broken = load.kind;
  bond.load = load.share / b.strength;
  bond.energy = energy;
  bond.time = time_of(s);
  bond.place = s.record[b.i].place - (b.arm_i / b.length) * m.branch;
}

/// What broke in this step is booked in the order of bonds, whoever found it.
void book_breaks(Sample& s) {
  for (std::size_t n = 0; n < the<Bonds>(s).slots.size(); ++n) {
    if (the<Bonds>(s).slots[n].state != State::breaking) continue;
    end_bond(s, n);
    s.tally.dissipated_breakage += the<Bonds>(s).all[the<Bonds>(s).slots[n].bond].energy;
  }
}

/// The periodic images that bonds mean, where they are now.
void move_images(Sample& s) {
  const BondRow<double*> column = the<Bonds>(s).numbers.columns();
  for (const std::int32_t slot : the<Bonds>(s).numbers.across) {
    const Vec2 place = s.domain.way(the<Bonds>(s).slots[slot].shift),
               velocity = image_velocity(s, the<Bonds>(s).slots[slot].shift);
    column.image.x[slot] = place.x;
    column.image.y[slot] = place.y;
    column.image_velocity.x[slot] = velocity.x;
    column.image_velocity.y[slot] = velocity.y;
  }
}

/// One bond, by the law itself. True if it breaks.
template <class Law> bool look_at(Sample& s, const Law& law, std::size_t n) {
  BondSlot& b = the<Bonds>(s).slots[n];
  SlotForce<2>& force = s.list.force[the<Bonds>(s).place(s.list, n)];
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
  BondNumbers& numbers = the<Bonds>(s).numbers;
  const auto column = std::bit_cast<BondRow<const double*>>(numbers.columns());
  return {s.record.data(),
          s.angle.along[0].data(),
          numbers.i.data(),
          numbers.j.data(),
          column,
          &s.list.force[the<Bonds>(s).place(s.list, 0)],
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

void Bonds::make(Sample& s, const Packing& /*given*/) {
  if (s.contact.has_bonds()) all = s.start.bonds;
  s.start.bonds.clear();
}

void Bonds::list_others(Sample& s) {
  slots.clear();
  if (all.empty()) return;
  std::vector<std::int32_t> number(s.count);
  for (std::size_t k = 0; k < s.count; ++k) number[s.record[k].grain] = static_cast<std::int32_t>(k);
  const auto is_listed = [&](std::size_t n) {
    return all[n].broken == BondBreak::none || std::ranges::binary_search(reopened, static_cast<std::int32_t>(n));
  };
  for (std::size_t n = 0; n < all.size(); ++n)
    if (is_listed(n)) slots.push_back(slot_of(s, n, number));
  numbers = lined_up(slots);
  reopened.clear();
  for (std::size_t n = 0; n < slots.size(); ++n)
    if (all[slots[n].bond].broken != BondBreak::none) end_bond(s, n);
}

bool Bonds::joins(std::int32_t a, std::int32_t b) const {
  return std::ranges::any_of(all, [&](const Bond& bond) { return pair_key(bond.i, bond.j) == pair_key(a, b); });
}

void Bonds::add_forces(Sample& s, const ThreadPool& pool) {
  if (slots.empty()) return;
  move_images(s);
  const BondTask task = bond_task(s);
  const Kernel::BondLoop loop = s.kernel->bond_loops[s.contact.bonds.index()];
  std::atomic<bool> broke = false;
  s.contact.bonds.visit([&](const auto& law) {
    pool.for_ranges(the<Bonds>(s).slots.size(), [&](std::size_t begin, std::size_t end) {
      if (!loop(task, s.contact.bonds, begin, end)) return;
      for (std::size_t n = begin; n < end; ++n)
        if (task.look[n] != 0 && look_at(s, law, n)) broke = true;
    });
  });
  if (broke) book_breaks(s);
}

void Bonds::add_moments(const Sample& s, std::array<Vec2, 2>& sum) const {
  for (std::size_t n = 0; n < slots.size(); ++n) {
    const SlotForce<2>& f = s.list.force[place(s.list, n)];
    if (!acts(f)) continue;
    const Vec2 branch = beam_motion(s, slots[n]).branch;
    for (int axis = 0; axis < 2; ++axis) sum[axis] += branch[axis] * f.on_i;
  }
}

void Bonds::each_joint(const Sample& s, const std::function<void(std::int32_t, std::int32_t, double)>& see) const {
  for (std::size_t n = 0; n < slots.size(); ++n)
    if (const SlotForce<2>& f = s.list.force[place(s.list, n)]; acts(f))
      see(slots[n].i, slots[n].j, std::hypot(f.on_i.x, f.on_i.y));
}

void Bonds::add_energy(const Sample& s, Energies& energies) const { energies.elastic += bond_energy(s); }

/// With their forces now, by the caller's grains.
void Bonds::report(const Sample& s, Packing& out) const {
  std::vector<Bond>& bonds = out.bonds = all;
  s.contact.bonds.visit([&](const auto& law) {
    for (const BondSlot& b : the<Bonds>(s).slots) {
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
}

std::vector<std::int32_t> Bonds::broken_in_list() const {
  std::vector<std::int32_t> broken;
  for (const BondSlot& b : slots)
    if (b.state == State::broken) broken.push_back(b.bond);
  return broken;
}

bool Bonds::are_within(const Sample& s, const std::vector<std::int32_t>& broken) const {
  const auto is_grain = [&](std::int32_t k) { return k >= 0 && static_cast<std::size_t>(k) < s.count; };
  return std::ranges::all_of(all, [&](const Bond& b) { return is_grain(b.i) && is_grain(b.j); }) &&
         std::ranges::all_of(broken,
                             [&](std::int32_t n) { return n >= 0 && static_cast<std::size_t>(n) < all.size(); });
}

double bond_energy(const Sample& s) {
  double sum = 0;
  s.contact.bonds.visit([&](const auto& law) {
    for (const BondSlot& b : the<Bonds>(s).slots)
      if (b.state == State::holds) sum += law.energy(b.beam, beam_motion(s, b).strain);
  });
  return sum;
}

void make_bonds(Sample& s, const ThreadPool& pool) {
  if (!s.contact.has_bonds()) throw InputError("bonds cannot be created if contact.bonds is \"none\"");
  synchronise(s);
  list_anew(s, pool);
  bond_near_pairs(s);
  list_anew(s, pool);
  const double wanted = s.integration.safety * shortest_bond_time(s);
  if (!s.integration.time_step && wanted < s.dt) change_step(s, wanted);
  allow_step(s, "its bonds");
}

BondCount count_bonds(const Sample& s) {
  const auto count = [&](BondBreak how) {
    return static_cast<std::size_t>(std::ranges::count(the<Bonds>(s).all, how, &Bond::broken));
  };
  return {count(BondBreak::none), count(BondBreak::tension), count(BondBreak::bending), count(BondBreak::shear),
          bond_energy(s)};
}

}  // namespace arenite::dem
