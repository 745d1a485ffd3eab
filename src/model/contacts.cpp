#include "model/contacts.hpp"

#include <limits>

namespace arenite {

void Contacts::add(std::int32_t a, std::int32_t b, Vec2 normal, double normal_force, double tangential_force,
                   double arm_a, double arm_b) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  i.push_back(a);
  j.push_back(b);
  nx.push_back(normal.x);
  ny.push_back(normal.y);
  fn.push_back(normal_force);
  ft.push_back(tangential_force);
  arm_i.push_back(arm_a);
  arm_j.push_back(arm_b);
  overlap.push_back(unknown);
  sliding_velocity.push_back(unknown);
  glued.push_back(0);
}

}  // namespace arenite
