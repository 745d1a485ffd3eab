#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/packing.hpp"

namespace arenite::fields {

/// Loops of the contact network in the plane: its smallest cycles, which are the faces of the planar graph of grains
/// (vertices at centres) and contacts.
struct Loops {
  std::size_t grains = 0, contacts = 0;  ///< vertices V and edges E of the network
  std::size_t parts = 0;                 ///< connected components C of the network
  std::size_t rattlers = 0;              ///< grains left out
  std::size_t outlines =
      0;  ///< closed walks that bound no loop: around a part, or along a strip around a periodic cell
  std::vector<std::int32_t> edges;     ///< contacts of each loop; one that is passed on both sides counts twice
  std::vector<double> area;            ///< of each loop's polygon of centres, m^2
  std::vector<std::size_t> histogram;  ///< number of loops by number of contacts (index)
  double mean_edges = 0;               ///< NaN without loops
};

/// The network is that of contacts between grains that carry a normal force, without rattlers: grains with fewer than
/// two such contacts, again and again until none is left. At every grain contacts are ordered by direction; a loop is a
/// walk that turns at each grain into the next contact clockwise, so that it keeps the loop on its left. With walls L =
/// E - V + C; in a periodic cell whose network goes round it one way or both in one piece L = E - V (Euler). Contacts
/// are taken not to cross, as disks that overlap little do not. Contacts with walls close no loops. A part that floats
/// inside a loop of another is not cut out of it. `bearing_only` = false: contacts without force count too, as for
/// networks whose forces are not known.
Loops find_loops(const Packing& packing, bool bearing_only = true);

}  // namespace arenite::fields
