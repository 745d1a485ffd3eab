#include "grains/dem/neighbours.hpp"

#include <algorithm>

namespace arenite::dem {

bool is_marked_as_glued(const Sample& s, std::int32_t a, std::int32_t b) {
  const auto& zone = s.start.grains.zone;
  const auto& glued = s.contact.glued_pairs;  // sorted, low index first
  if (glued.empty()) return zone[static_cast<std::size_t>(a)] > 0 && zone[static_cast<std::size_t>(b)] > 0;
  a = grain_of(s, a), b = grain_of(s, b);
  return std::binary_search(glued.begin(), glued.end(), std::pair{std::min(a, b), std::max(a, b)});
}

namespace {

bool bonds_break(const Sample& s) {
  return std::visit([](const auto& law) { return law.breaks; }, s.contact.adhesion);
}

}  // namespace

bool is_glued(const Sample& s, std::int32_t a, std::int32_t b) {
  if (!s.glue || !s.contact.adheres()) return false;
  return bonds_break(s) ? std::binary_search(s.live_bonds.begin(), s.live_bonds.end(), pair_key(a, b)) : is_marked_as_glued(s, a, b);
}

void bond_touching_pairs(Sample& s) {
  s.live_bonds.clear();
  if (s.glue && bonds_break(s)) {
    for (std::size_t p = 0; p < s.list.pairs; ++p) {
      const auto& a = s.record[static_cast<std::size_t>(s.list.i[p])];
      const auto& b = s.record[static_cast<std::size_t>(s.list.j[p])];
      const double reach = (1 + 1e-6) * (a.radius + b.radius);
      const Vec2 d{a.x - b.x, a.y - b.y};
      if (dot(d, d) < reach * reach && is_marked_as_glued(s, a.grain, b.grain)) s.live_bonds.push_back(slot_key(s, p));
    }
    std::sort(s.live_bonds.begin(), s.live_bonds.end());
  }
  ContactList& list = s.list;
  for (std::size_t p = 0; p < list.pairs; ++p) {
    const auto& a = s.record[static_cast<std::size_t>(list.i[p])];
    const auto& b = s.record[static_cast<std::size_t>(list.j[p])];
    list.strength[p] = s.coefficients.pair(a.material, b.material, a.mass, b.mass, a.radius, b.radius, is_glued(s, a.grain, b.grain)).strength;
  }
}

}  // namespace arenite::dem
