#include "model/elasticity/disk_stress.hpp"

#include <algorithm>
#include <functional>
#include <numbers>

namespace arenite::elasticity {

std::vector<double> stress_of_disks(const Packing& packing) {
  const Contacts& contacts = packing.contacts;
  std::vector<double> pushed(packing.grains.size(), 0.0);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    pushed[static_cast<std::size_t>(contacts.i[c])] += contacts.fn[c];
    if (!contacts.is_wall(c)) pushed[static_cast<std::size_t>(contacts.j[c])] += contacts.fn[c];
  }
  for (std::size_t i = 0; i < pushed.size(); ++i)
    pushed[i] /= -2 * std::numbers::pi * packing.grains.radius[i] * packing.domain.thickness;
  return pushed;
}

std::vector<double> stress_change(const Packing* low, const Packing& high) {
  std::vector<double> change = stress_of_disks(high);
  if (!low) return change;
  const std::vector<double> released = stress_of_disks(*low);
  std::ranges::transform(change, released, change.begin(), std::minus());
  return change;
}

}  // namespace arenite::elasticity
