#pragma once
#include <cstdint>
#include <vector>

#include "model/packing.hpp"

namespace arenite::texture {

/// By what a picture tells forces apart, N.
struct ForceScale {
  double mean = 0;     ///< normal forces above it are strong; widths of bars are in proportion to it; 0: none pushes
  double tension = 0;  ///< those below it pull: in equilibrium the dashpots leave traces of tension that mean nothing
};

/// By the mean that was `measured` of the sample, where it is known and above 0, or else by that of the contacts
/// between grains that push. `doubtful`: 1 for contacts that may be absent and do not count; empty: there is none.
template <int D>
ForceScale force_scale(const ContactsIn<D>& contacts, double measured, const std::vector<std::uint8_t>& doubtful = {});

/// Mean force of the contacts between grains that push, of several states together: one scale for all of them, N; 0
/// where none pushes.
template <int D> double mean_push(const std::vector<const ContactsIn<D>*>& states);

/// Whether some contact has a force; else nobody knows them.
template <int D> bool has_forces(const ContactsIn<D>& contacts);
inline constexpr const char* forces_not_known =
    "The forces of the contacts are not known, so statistics of forces and stresses are omitted.";

}  // namespace arenite::texture
