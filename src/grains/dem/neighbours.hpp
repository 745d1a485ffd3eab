#pragma once
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Sorts the disks by cell, wraps them into a periodic cell, makes the ghosts and lists every pair (and wall) closer
/// than the skin. What touching pairs remember is kept. Throws CannotGoOn, naming grain and step, if a grain
/// has left the walls or a coordinate is not finite.
void rebuild_list(Sample& sample, const Team& team = Team());

/// Lists the pairs at the records' present order and places without sorting; what rebuild_list does at its end, and
/// what a restored sample needs.
void list_contacts(Sample& sample, const Team& team = Team());

/// How far a disk may be from its place in the list, less the affine motion of the cell, before the list may miss a
/// contact, m; 0 or less if the walls or the cell have moved too far for that.
double list_leeway(const Sample& sample);

}  // namespace arenite::dem
