#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "grains/dem/bounds.hpp"
#include "grains/dem/contact_list.hpp"

namespace arenite::dem {

/// A bond that holds, with what follows from its making and from where its disks are numbered now. Its force stands
/// behind those of the contacts, in ContactList::force at Bonds::place.
struct BondSlot : BondRow<double> {
  enum class State : std::int32_t { holds, breaking, broken };
  std::int32_t bond = 0;      ///< place in Bonds::all
  std::int32_t i = 0, j = 0;  ///< inner numbers of its disks
  Cells<2> shift;             ///< by which the image of j that is meant is away from j
  State state = State::holds;
};

/// The slots' numbers side by side, for the loop over them.
struct BondNumbers {
  std::vector<std::int32_t> i, j;
  Components<bond_columns> column;  ///< in the order of BondRow
  std::vector<std::uint8_t> look;
  std::vector<std::int32_t> across;  ///< slots that mean another image of j than j itself
  bool damped = false;
  BondRow<double*> columns() { return std::bit_cast<BondRow<double*>>(column.data()); }
};

/// A slot for the bond at that place, by the disks' present numbers (by grain) and places.
BondSlot slot_of(const Sample& sample, std::size_t place, const std::vector<std::int32_t>& number);
BondNumbers lined_up(const std::vector<BondSlot>& slots);

/// Takes a bond out of the list, in which it keeps its place until the list is built anew.
void end_bond(Sample& sample, std::size_t slot);

/// Dashpots of the listed bonds, from the present masses.
void renew_bond_dashpots(Sample& sample);

/// Bonds every two grains whose gap is at most what the law bridges (grains that touch: to a millionth of their radii),
/// where glued grains are marked only those, unless they have or had a bond already. The list must have just been
/// built.
void bond_near_pairs(Sample& sample);

/// Bounds of what bonds add to the rates of the contacts. Each bond is given its share of its grains' masses: a grain's
/// over the number of its bonds.
Rates bond_rates(const Sample& sample);

/// Shortest half period of two grains on their bond, with their contact beside it, s; infinite without bonds.
double shortest_bond_time(const Sample& sample);

}  // namespace arenite::dem
