#include "grains/dem/parts/bonds.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {

namespace {

using State = BondState;

/// Energy that the sample loses with a bond. Half of its last step's work was still done by it, that of its force then
/// at the velocities before.
template <int D>
double energy_of_break(const SampleIn<D>& s, const BondSlotIn<D>& b, const BeamMotionIn<D>& m,
                       const BeamForceIn<D>& force, double energy) {
  const BeamStrainIn<D> rate =
      strain_rate(b, m, velocity_beside(s, b.i, b.j, image_velocity(s, b.shift)), s.omega[b.i], s.omega[b.j]);
  return energy - time_behind(s) * power_of(force, rate);
}

template <int D>
void note_break(SampleIn<D>& s, BondSlotIn<D>& b, const BeamMotionIn<D>& m, const BeamLoad& load, double energy) {
  BondIn<D>& bond = the<BondsIn<D>>(s).all[b.bond];
  b.state = State::breaking;
  bond.broken = load.kind;
  bond.load = load.share / b.strength;
  bond.energy = energy;
  bond.time = time_of(s);
  bond.place = s.record[b.i].place - (b.arm_i / b.length) * m.branch;
}

/// What broke in this step is booked in the order of bonds, whoever found it.
template <int D> void book_breaks(SampleIn<D>& s) {
  const auto& bonds = the<BondsIn<D>>(s);
  for (std::size_t n = 0; n < bonds.slots.size(); ++n) {
    if (bonds.slots[n].state != State::breaking) continue;
    end_bond(s, n);
    s.tally.dissipated_breakage += bonds.all[bonds.slots[n].bond].energy;
  }
}

/// The periodic images that bonds mean, where they are now.
template <int D> void move_images(SampleIn<D>& s) {
  auto& bonds = the<BondsIn<D>>(s);
  for (const std::int32_t slot : bonds.numbers.across) {
    const Cells<D> shift = bonds.slots[slot].shift;
    const Vec<D> place = s.domain.way(shift), velocity = image_velocity(s, shift);
    auto& row = bonds.numbers.row[static_cast<std::size_t>(slot) / 8];
    for (int axis = 0; axis < D; ++axis) {
      row.image[axis][slot % 8] = place[axis];
      row.image_velocity[axis][slot % 8] = velocity[axis];
    }
  }
}

/// One bond, by the law itself. True if it breaks.
template <int D, class Law> bool look_at(SampleIn<D>& s, const Law& law, std::size_t n) {
  auto& bonds = the<BondsIn<D>>(s);
  BondSlotIn<D>& b = bonds.slots[n];
  SlotForce<D>& force = s.list.force[bonds.place(s.list, n)];
  force = {};
  if (b.state != State::holds) return false;
  const BeamMotionIn<D> m = beam_motion(s, b);
  const BeamForceIn<D> f = law.elastic(b.beam, m.strain);
  if (const BeamLoad load = law.load(b.beam, f); load.share >= b.strength) {
    note_break(s, b, m, load, energy_of_break(s, b, m, f, law.energy(b.beam, m.strain)));
    return true;
  }
  force = beam_slot_force(b, m, f + beam_dashpots(s, b, m));
  return false;
}

const double* attitudes_of(const Sample& s) { return s.angle.along[0].data(); }
const geometry::Rotation* attitudes_of(const SampleIn<3>& s) { return the<BondsIn<3>>(s).attitudes.now.data(); }

template <int D> BondTask<D> bond_task(SampleIn<D>& s) {
  auto& bonds = the<BondsIn<D>>(s);
  return {s.record.data(),           attitudes_of(s),          bonds.numbers.i.data(),
          bonds.numbers.j.data(),    bonds.numbers.row.data(), &s.list.force[bonds.place(s.list, 0)],
          bonds.numbers.look.data(), bonds.numbers.damped};
}

/// The loop over the bonds, compiled for this processor: true of a range with bonds that need a closer look.
template <int D> struct CompiledLoop {
  BondTask<D> task;
  typename KernelIn<D>::BondLoop loop;
  const BondLaw& law;
  bool operator()(std::size_t begin, std::size_t end) const { return loop(task, law, begin, end); }
  bool asks_for(std::size_t slot) const { return task.look[slot] != 0; }
};
template <int D> CompiledLoop<D> loop_over(SampleIn<D>& s) {
  move_images(s);
  return {bond_task(s), s.kernel->bond_loops[s.contact.bonds.index()], s.contact.bonds};
}

/// How grains have turned since they were bonded, where a bond says that.
void put_turns(const Sample& /*sample*/, const BondSlot& /*slot*/, Bond& /*bond*/) {}
void put_turns(const SampleIn<3>& s, const BondSlotIn<3>& b, BondIn<3>& bond) {
  const auto& now = the<BondsIn<3>>(s).attitudes.now;
  bond.angle_i = geometry::vector_of(now[s.record[b.i].grain] * geometry::rotation_by(-bond.angle_i));
  bond.angle_j = geometry::vector_of(now[s.record[b.j].grain] * geometry::rotation_by(-bond.angle_j));
}

}  // namespace

template <int D> void BondsIn<D>::make(SampleIn<D>& s, const PackingIn<D>& /*given*/) {
  if (s.contact.has_bonds()) all = s.start.bonds;
  for (BondIn<D>& bond : all) take_up(bond);
  s.start.bonds.clear();
}

template <int D> void BondsIn<D>::list_others(SampleIn<D>& s) {
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

template <int D> bool BondsIn<D>::joins(std::int32_t a, std::int32_t b) const {
  return std::ranges::any_of(all, [&](const BondIn<D>& bond) { return pair_key(bond.i, bond.j) == pair_key(a, b); });
}

template <int D> void BondsIn<D>::add_forces(SampleIn<D>& s, const ThreadPool& pool) {
  if (slots.empty()) return;
  attitudes.follow(s, pool);
  const auto loop = loop_over(s);
  std::atomic<bool> broke = false;
  s.contact.bonds.visit([&](const auto& law) {
    pool.for_ranges(slots.size(), [&](std::size_t begin, std::size_t end) {
      if (!loop(begin, end)) return;
      for (std::size_t n = begin; n < end; ++n)
        if (loop.asks_for(n) && look_at(s, law, n)) broke = true;
    });
  });
  if (broke) book_breaks(s);
}

template <int D> void BondsIn<D>::add_moments(const SampleIn<D>& s, std::array<Vec<D>, D>& sum) const {
  for (std::size_t n = 0; n < slots.size(); ++n) {
    const SlotForce<D>& f = s.list.force[place(s.list, n)];
    if (!acts(f)) continue;
    const Vec<D> branch = beam_motion(s, slots[n]).branch;
    for (int axis = 0; axis < D; ++axis) sum[axis] += branch[axis] * f.on_i;
  }
}

template <int D>
void BondsIn<D>::each_joint(const SampleIn<D>& s,
                            const std::function<void(std::int32_t, std::int32_t, double)>& see) const {
  for (std::size_t n = 0; n < slots.size(); ++n)
    if (const SlotForce<D>& f = s.list.force[place(s.list, n)]; acts(f))
      see(slots[n].i, slots[n].j, hypotenuse(f.on_i));
}

template <int D> void BondsIn<D>::add_energy(const SampleIn<D>& s, Energies& energies) const {
  energies.elastic += bond_energy(s);
}

/// With their forces now, by the caller's grains.
template <int D> void BondsIn<D>::report(const SampleIn<D>& s, PackingIn<D>& out) const {
  out.bonds = all;
  s.contact.bonds.visit([&](const auto& law) {
    for (const BondSlotIn<D>& b : slots) {
      if (b.state != State::holds) continue;
      const BeamMotionIn<D> m = beam_motion(s, b);
      const BeamForceIn<D> f = law.elastic(b.beam, m.strain);
      BondIn<D>& bond = out.bonds[b.bond];
      put_forces(b, m, f, bond);
      put_turns(s, b, bond);
      bond.energy = law.energy(b.beam, m.strain);
      bond.load = law.load(b.beam, f).share / b.strength;
    }
  });
}

template <int D> std::vector<std::int32_t> BondsIn<D>::broken_in_list() const {
  std::vector<std::int32_t> broken;
  for (const BondSlotIn<D>& b : slots)
    if (b.state == State::broken) broken.push_back(b.bond);
  return broken;
}

template <int D> bool BondsIn<D>::are_within(const SampleIn<D>& s, const std::vector<std::int32_t>& broken) const {
  const auto is_grain = [&](std::int32_t k) { return k >= 0 && static_cast<std::size_t>(k) < s.count; };
  return std::ranges::all_of(all, [&](const BondIn<D>& b) { return is_grain(b.i) && is_grain(b.j); }) &&
         std::ranges::all_of(broken,
                             [&](std::int32_t n) { return n >= 0 && static_cast<std::size_t>(n) < all.size(); });
}

template <int D> double bond_energy(const SampleIn<D>& s) {
  double sum = 0;
  s.contact.bonds.visit([&](const auto& law) {
    for (const BondSlotIn<D>& b : the<BondsIn<D>>(s).slots)
      if (b.state == State::holds) sum += law.energy(b.beam, beam_motion(s, b).strain);
  });
  return sum;
}

template <int D> void make_bonds(SampleIn<D>& s, const ThreadPool& pool) {
  if (!s.contact.has_bonds()) throw InputError("bonds cannot be created if contact.bonds is \"none\"");
  synchronise(s);
  list_anew(s, pool);
  the<BondsIn<D>>(s).attitudes.follow(s, pool);
  bond_near_pairs(s);
  list_anew(s, pool);
  const double wanted = s.integration.safety * shortest_bond_time(s);
  if (!s.integration.time_step && wanted < s.dt) change_step(s, wanted);
  allow_step(s, "its bonds");
}

template <int D> BondCount count_bonds(const SampleIn<D>& s) {
  const auto count = [&](BondBreak how) {
    return static_cast<std::size_t>(std::ranges::count(the<BondsIn<D>>(s).all, how, &BondIn<D>::broken));
  };
  return {count(BondBreak::none),  count(BondBreak::tension),  count(BondBreak::bending),
          count(BondBreak::shear), count(BondBreak::twisting), bond_energy(s)};
}

#define ARENITE_OF(D)                                        \
  template struct BondsIn<D>;                                \
  template double bond_energy(const SampleIn<D>&);           \
  template void make_bonds(SampleIn<D>&, const ThreadPool&); \
  template BondCount count_bonds(const SampleIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::dem
