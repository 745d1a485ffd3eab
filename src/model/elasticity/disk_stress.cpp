#include "model/elasticity/disk_stress.hpp"

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

}  // namespace arenite::elasticity
