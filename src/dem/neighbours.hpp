#pragma once
#include "dem/sample.hpp"

namespace arenite::dem {

/// Sorts the disks by cell, wraps them into a periodic cell, makes the ghosts and lists every pair (and wall) closer
/// than the skin. What touching pairs remember is kept. Throws std::runtime_error, naming grain and step, if a grain
/// has left the walls or a coordinate is not finite.
void rebuild_list(Sample& sample);

/// Lists the pairs at the records' present order and places without sorting; what rebuild_list does at its end, and
/// what a restored sample needs.
void list_contacts(Sample& sample);

/// Decides anew which listed pairs attract, after glue was switched on or off. Where bonds break for good, the glued
/// pairs that touch now (to a millionth of their radii) are the bonds there are.
void bond_touching_pairs(Sample& sample);

/// What a contact carries over a rebuild of the list, keyed by the grains (or grain and wall) that it joins. A periodic
/// cell is at least two reaches wide, so no pair meets twice.
struct Carried {
  std::uint64_t key;
  double memory;
  std::uint8_t bond;
};

/// Gives the listed contacts what they carry; `all` is sorted by key.
void carry_into(Sample& sample, const std::vector<Carried>& all);

/// How far a disk may be from its place in the list, less the affine motion of the cell, before the list may miss a
/// contact, m; 0 or less if the walls or the cell have moved too far for that.
double list_leeway(const Sample& sample);

/// Copies the sources of ghosts to their images (positions and seen velocities).
void refresh_ghosts(Sample& sample);

}  // namespace arenite::dem
