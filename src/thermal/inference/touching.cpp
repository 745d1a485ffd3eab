#include "thermal/inference/touching.hpp"

namespace arenite::inference {

std::vector<std::vector<Touch>> touches_of_grains(const Packing& packing, const std::vector<Vec2>& centre) {
  const Contacts& contacts = packing.contacts;
  std::vector<std::vector<Touch>> touches(centre.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto i = static_cast<std::size_t>(contacts.i[c]);
    const int contact = static_cast<int>(c);
    if (contacts.is_wall(c)) {
      touches[i].push_back({contact, -1, inward_normal(contacts.wall_side(c)), 0});
      continue;
    }
    const auto j = static_cast<std::size_t>(contacts.j[c]);
    const Vec2 branch = packing.domain.nearest_image(centre[i] - centre[j]);
    const double distance = norm(branch);
    const Vec2 n = (1 / distance) * branch;
    touches[i].push_back({contact, static_cast<int>(j), n, distance});
    touches[j].push_back({contact, static_cast<int>(i), -n, distance});
  }
  return touches;
}

}  // namespace arenite::inference
