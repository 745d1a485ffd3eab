#pragma once
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Forces of all listed contacts from the records (whose ghosts are fresh), into the list's slots; then the forces of
/// the walls. Springs of the friction law move on by one step.
void compute_forces(Sample& sample, const Team& team = Team());

/// Forces of the edges of a periodic cell, the means over all its cuts: (1/W) sum f_x l_x. Not part of compute_forces,
/// because only driven edges and readers need them.
void sum_edge_forces(Sample& sample, const Team& team = Team());

/// Sum of a disk's contact forces (x, y) and torque, its slots in a fixed order.
struct Load {
  double fx = 0, fy = 0, torque = 0;
};
inline Load contact_load(const ContactList& list, std::size_t k) {
  const auto sum = [&](std::size_t q) {
    SlotForce total;
    for (auto g = static_cast<std::size_t>(list.first[q]); g < static_cast<std::size_t>(list.first[q + 1]); g += 4) {
      const auto at = [&](std::size_t n) -> const SlotForce& { return list.force[static_cast<std::size_t>(list.group[g + n])]; };
      const SlotForce &a = at(0), &b = at(1), &c = at(2), &d = at(3);
      total.fx += (a.fx + b.fx) + (c.fx + d.fx);
      total.fy += (a.fy + b.fy) + (c.fy + d.fy);
      total.torque_i += (a.torque_i + b.torque_i) + (c.torque_i + d.torque_i);
      total.torque_j += (a.torque_j + b.torque_j) + (c.torque_j + d.torque_j);
    }
    return total;
  };
  const SlotForce own = sum(2 * k), reaction = sum(2 * k + 1);
  return {own.fx - reaction.fx, own.fy - reaction.fy, own.torque_i + reaction.torque_j};
}

}  // namespace arenite::dem
