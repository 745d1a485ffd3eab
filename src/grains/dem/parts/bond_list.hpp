#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "grains/dem/bounds.hpp"
#include "grains/dem/contact_list.hpp"

namespace arenite::dem {

enum class BondState : std::int32_t { holds, breaking, broken };

/// A bond that holds, with what follows from its making and from where its disks are numbered now. Its force stands
/// behind those of the contacts, in ContactList::force at Bonds::place.
template <int D> struct BondSlotIn : BondRow<D, double> {
  using State = BondState;
  std::int32_t bond = 0;      ///< place in Bonds::all
  std::int32_t i = 0, j = 0;  ///< inner numbers of its disks
  Cells<D> shift;             ///< by which the image of j that is meant is away from j
  State state = State::holds;
};
using BondSlot = BondSlotIn<2>;

/// The slots' numbers side by side, for the loop over them.
template <int D> struct BondNumbers {
  std::vector<std::int32_t> i, j;
  std::vector<BondRow<D, Eight>> row;
  std::vector<std::uint8_t> look;
  std::vector<std::int32_t> across;  ///< slots that mean another image of j than j itself
  bool damped = false;
};

/// A slot for the bond at that place, by the disks' present numbers (by grain) and places.
template <int D>
BondSlotIn<D> slot_of(const SampleIn<D>& sample, std::size_t place, const std::vector<std::int32_t>& number);
template <int D> BondNumbers<D> lined_up(const std::vector<BondSlotIn<D>>& slots);

/// Takes a bond out of the list, in which it keeps its place until the list is built anew.
template <int D> void end_bond(SampleIn<D>& sample, std::size_t slot);

/// Dashpots of the listed bonds, from the present masses.
template <int D> void renew_bond_dashpots(SampleIn<D>& sample);

/// A bond that a packing brings, as a sample holds it whose grains begin with no turn.
inline void take_up(Bond& /*bond*/) {}
inline void take_up(BondIn<3>& bond) { bond.angle_i = -bond.angle_i, bond.angle_j = -bond.angle_j; }

/// Bonds every two grains whose gap is at most what the law bridges (grains that touch: to a millionth of their radii),
/// where glued grains are marked only those, unless they have or had a bond already. The list must have just been
/// built.
template <int D> void bond_near_pairs(SampleIn<D>& sample);

/// Bounds of what bonds add to the rates of the contacts. Each bond is given its share of its grains' masses: a grain's
/// over the number of its bonds.
template <int D> Rates bond_rates(const SampleIn<D>& sample);

/// Shortest half period of two grains on their bond, with their contact beside it, s; infinite without bonds.
template <int D> double shortest_bond_time(const SampleIn<D>& sample);

}  // namespace arenite::dem
