#pragma once
#include "core/threads.hpp"
#include "grains/dem/forces.hpp"

namespace arenite::dem {

/// Bonds every two grains whose gap is at most what the law bridges (grains that touch: to a millionth of their radii),
/// where glued grains are marked only those, unless they have or had a bond already. The list must have just been
/// built.
void bond_near_pairs(Sample& sample);

/// Lists the bonds that hold, by the disks' present numbers and places. Part of list_contacts.
void list_bonds(Sample& sample);

/// Takes a bond out of the list, in which it keeps its place until the list is built anew.
void end_bond(Sample& sample, std::size_t slot);

/// Dashpots of the listed bonds, from the present masses.
void renew_bond_dashpots(Sample& sample);

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

/// Fills the bonds' places in the list of forces and ends the bonds whose stresses exceed their strength; what they
/// held is booked as dissipated.
void add_bond_forces(Sample& sample, const ThreadPool& pool);

/// All bonds there are and were, with their forces now, by the caller's grains.
std::vector<Bond> bonds_of(const Sample& sample);

/// What the bonds hold, J.
double bond_energy(const Sample& sample);

/// How fast something rings, and how fast that dies away.
struct Rates {
  double frequency_squared = 0, damping = 0;  ///< 1/s^2, 1/s
};
/// Bounds of what bonds add to the rates of the contacts. Each bond is given its share of its grains' masses: a grain's
/// over the number of its bonds.
Rates bond_rates(const Sample& sample);

/// Shortest half period of two grains on their bond, with their contact beside it, s; infinite without bonds.
double shortest_bond_time(const Sample& sample);

}  // namespace arenite::dem
