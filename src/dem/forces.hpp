#pragma once
#include "dem/sample.hpp"

namespace arenite::dem {

/// Forces of all listed contacts from the records (whose ghosts are fresh), into the list's slots; then the forces of
/// the walls. Springs of the friction law move on by one step.
void compute_forces(Sample& sample);

/// Sum of a disk's contact forces (x, y) and torque, its slots in a fixed order.
struct Load {
  double fx = 0, fy = 0, torque = 0;
};
inline Load contact_load(const ContactList& list, std::size_t k) {
  Load sum;
  for (auto p = static_cast<std::size_t>(list.first[k]); p < static_cast<std::size_t>(list.first[k + 1]); ++p) {
    sum.fx += list.fx[p];
    sum.fy += list.fy[p];
    sum.torque += list.torque_i[p];
  }
  for (auto q = static_cast<std::size_t>(list.incoming_first[k]); q < static_cast<std::size_t>(list.incoming_first[k + 1]);
       ++q) {
    const auto p = static_cast<std::size_t>(list.incoming[q]);
    sum.fx -= list.fx[p];
    sum.fy -= list.fy[p];
    sum.torque += list.torque_j[p];
  }
  for (auto p = static_cast<std::size_t>(list.wall_first[k]); p < static_cast<std::size_t>(list.wall_first[k + 1]); ++p) {
    sum.fx += list.fx[p];
    sum.fy += list.fy[p];
    sum.torque += list.torque_i[p];
  }
  return sum;
}

}  // namespace arenite::dem
