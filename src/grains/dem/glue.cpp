#include "grains/dem/neighbours.hpp"

#include <algorithm>

namespace arenite::dem {

bool is_marked_as_glued(const Sample& s, std::int32_t a, std::int32_t b) {
  const auto& zone = s.start.grains.zone;
  const auto& glued = s.contact.glued_pairs;  // sorted, low index first
  if (glued.empty()) return zone[a] > 0 && zone[b] > 0;
  a = grain_of(s, a), b = grain_of(s, b);
  return std::binary_search(glued.begin(), glued.end(), std::pair{std::min(a, b), std::max(a, b)});
}

namespace {

bool bonds_break(const Sample& s) {
  return s.contact.adhesion.visit([](const auto& law) { return law.breaks; });
}

}  // namespace

bool is_glued(const Sample& s, std::int32_t a, std::int32_t b) {
  if (!s.glue || !s.contact.adheres()) return false;
  return bonds_break(s) ? std::binary_search(s.live_bonds.begin(), s.live_bonds.end(), pair_key(a, b)) : is_marked_as_glued(s, a, b);
}

Coefficients pair_coefficients(const Sample& s, const DiskRecord& a, const DiskRecord& b) {
  return s.coefficients.pair(a.material, b.material, a.mass, b.mass, a.radius, b.radius, is_glued(s, a.grain, b.grain));
}

void bond_touching_pairs(Sample& s) {
  s.live_bonds.clear();
  if (s.glue && bonds_break(s)) {
    for (std::size_t p = 0; p < s.list.pairs; ++p) {
      const DiskRecord &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
      const double reach = (1 + 1e-6) * (a.radius + b.radius);
      const Vec2 d = a.place - b.place;
      if (dot(d, d) < reach * reach && is_marked_as_glued(s, a.grain, b.grain)) s.live_bonds.push_back(slot_key(s, p));
    }
    std::sort(s.live_bonds.begin(), s.live_bonds.end());
  }
  for (std::size_t p = 0; p < s.list.pairs; ++p) s.list.strength[p] = pair_coefficients(s, s.record[s.list.i[p]], s.record[s.list.j[p]]).strength;
}

}  // namespace arenite::dem
