#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "grains/dem/parts/bond_list.hpp"
#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// The bonds that there are, and that there were.
struct BondCount {
  std::size_t intact = 0, in_tension = 0, in_bending = 0, in_shear = 0;  ///< whole ones; those broken so
  double energy = 0;                                                     ///< of the whole ones, J
  std::size_t made() const { return intact + in_tension + in_bending + in_shear; }
};

/// Beams of cement between grains.
struct Bonds : PartOf<2> {
  std::vector<Bond> all;               ///< sorted by their grains; without the forces of now
  std::vector<BondSlot> slots;         ///< of the bonds that held when the list was built
  BondNumbers numbers;                 ///< of these
  std::vector<std::int32_t> reopened;  ///< places of bonds that broke since the list was built that is about to be made

  void make(Sample& sample, const Packing& given);
  void list_others(Sample& sample);
  bool joins(std::int32_t a, std::int32_t b) const;
  std::size_t place(const ContactList& list, std::size_t slot) const {
    return place_of_force(list, first_force + slot);
  }
  std::size_t force_count() const { return slots.size(); }
  void each_force(const std::function<void(std::int32_t, std::int32_t, std::size_t)>& see) const {
    for (std::size_t n = 0; n < slots.size(); ++n) see(slots[n].i, slots[n].j, n);
  }
  /// Fills the bonds' places in the list of forces and ends the bonds whose stresses exceed their strength; what they
  /// held is booked as dissipated.
  void add_forces(Sample& sample, const ThreadPool& pool);
  void add_moments(const Sample& sample, std::array<Vec2, 2>& sum) const;
  void renew_dashpots(Sample& sample) { renew_bond_dashpots(sample); }
  void each_joint(const Sample& sample, const std::function<void(std::int32_t, std::int32_t, double)>& see) const;
  Rates added_rates(const Sample& sample) const { return bond_rates(sample); }
  double shortest_time(const Sample& sample, const std::function<double(double)>& /*tangent*/) const {
    return shortest_bond_time(sample);
  }
  void add_energy(const Sample& sample, Energies& energies) const;
  void report(const Sample& sample, Packing& out) const;
  template <class Members> void transfer(Sample& sample, Members& members) {
    std::vector<std::int32_t> broken = broken_in_list();
    members(all, broken);
    if (!members.reads()) return;
    members.expect(are_within(sample, broken));
    reopened = std::move(broken);
  }

 private:
  std::vector<std::int32_t> broken_in_list() const;
  bool are_within(const Sample& sample, const std::vector<std::int32_t>& broken) const;
};

/// Where a bond's grains are now, and how it is strained.
struct BeamMotion {
  Vec2 branch, normal;  ///< from the meant image of j to i
  double distance = 0;
  BeamStrain<double> strain;
};
BeamMotion beam_motion(const Sample& sample, const BondSlot& slot);

/// A bond's force on i and its torques, from what the beam answers with.
SlotForce<2> beam_slot_force(const BondSlot& slot, const BeamMotion& motion, const BeamForce<double>& force);
/// What its dashpots have in that.
BeamForce<double> beam_dashpots(const Sample& sample, const BondSlot& slot, const BeamMotion& motion);

/// Bonds grains that touch now or nearly (contact.bonds), free of stress, unless they are or were bonded already. A
/// step that the bonds do not allow is shortened, or refused (InputError) where it was given.
void make_bonds(Sample& sample, const ThreadPool& pool = ThreadPool());

/// What the bonds hold, J.
double bond_energy(const Sample& sample);

BondCount count_bonds(const Sample& sample);

}  // namespace arenite::dem
