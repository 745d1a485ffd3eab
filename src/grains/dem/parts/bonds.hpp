#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "grains/dem/parts/attitudes.hpp"
#include "grains/dem/parts/beam_motion.hpp"
#include "grains/dem/parts/bond_list.hpp"
#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// The bonds that there are, and that there were.
struct BondCount {
  std::size_t intact = 0, in_tension = 0, in_bending = 0, in_shear = 0, in_twisting = 0;  ///< whole; broken so
  double energy = 0;                                                                      ///< of the whole ones, J
  std::size_t made() const { return intact + in_tension + in_bending + in_shear + in_twisting; }
};

/// Beams of cement between grains.
template <int D> struct BondsIn : PartOf<D> {
  using S = SampleIn<D>;
  std::vector<BondIn<D>> all;          ///< sorted by their grains; without the forces of now
  std::vector<BondSlotIn<D>> slots;    ///< of the bonds that held when the list was built
  BondNumbers<D> numbers;              ///< of these
  Attitudes<D> attitudes;              ///< of the grains
  std::vector<std::int32_t> reopened;  ///< places of bonds that broke since the list was built that is about to be made

  void make(S& sample, const PackingIn<D>& given);
  void list_others(S& sample);
  bool joins(std::int32_t a, std::int32_t b) const;
  std::size_t place(const ContactListIn<D>& list, std::size_t slot) const {
    return place_of_force(list, this->first_force + slot);
  }
  std::size_t force_count() const { return slots.size(); }
  void each_force(const std::function<void(std::int32_t, std::int32_t, std::size_t)>& see) const {
    for (std::size_t n = 0; n < slots.size(); ++n) see(slots[n].i, slots[n].j, n);
  }
  /// Fills the bonds' places in the list of forces and ends the bonds whose stresses exceed their strength; what they
  /// held is booked as dissipated.
  void add_forces(S& sample, const ThreadPool& pool);
  void add_moments(const S& sample, std::array<Vec<D>, D>& sum) const;
  void renew_dashpots(S& sample) { renew_bond_dashpots(sample); }
  void each_joint(const S& sample, const std::function<void(std::int32_t, std::int32_t, double)>& see) const;
  Rates added_rates(const S& sample) const { return bond_rates(sample); }
  double shortest_time(const S& sample, const std::function<double(double)>& /*tangent*/) const {
    return shortest_bond_time(sample);
  }
  void add_energy(const S& sample, Energies& energies) const;
  void report(const S& sample, PackingIn<D>& out) const;
  template <class Members> void transfer(S& sample, Members& members) {
    std::vector<std::int32_t> broken = broken_in_list();
    members(all, broken);
    if (!all.empty()) attitudes.transfer(members);
    if (!members.reads()) return;
    members.expect(are_within(sample, broken) && attitudes.fit(sample.count));
    reopened = std::move(broken);
  }

 private:
  std::vector<std::int32_t> broken_in_list() const;
  bool are_within(const S& sample, const std::vector<std::int32_t>& broken) const;
};
using Bonds = BondsIn<2>;

/// Bonds grains that touch now or nearly (contact.bonds), free of stress, unless they are or were bonded already. A
/// step that the bonds do not allow is shortened, or refused (InputError) where it was given.
template <int D> void make_bonds(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// What the bonds hold, J.
template <int D> double bond_energy(const SampleIn<D>& sample);

template <int D> BondCount count_bonds(const SampleIn<D>& sample);

}  // namespace arenite::dem
