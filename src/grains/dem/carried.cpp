#include "grains/dem/carried.hpp"

#include <algorithm>

namespace arenite::dem {

void carry_into(Sample& s, const std::vector<Carried>& all) {
  if (all.empty()) return;
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    const std::uint64_t key = slot_key(s, p);
    const auto found = std::lower_bound(all.begin(), all.end(), key,
                                        [](const Carried& c, std::uint64_t k) { return c.key < k; });
    if (found == all.end() || found->key != key) continue;
    s.list.memory[p] = found->memory;
    s.list.bond[p] = found->bond;
  }
}

namespace {

/// The slot that joins disk a with disk b, or with wall b < 0; the empty slot if there is none.
std::size_t find_slot(const ContactList& list, std::int32_t a, std::int32_t b) {
  const auto slots = [&](std::size_t q, auto&& joins) {
    for (auto g = static_cast<std::size_t>(list.first[q]); g < static_cast<std::size_t>(list.first[q + 1]); ++g) {
      const auto p = static_cast<std::size_t>(list.group[g]);
      if (p < list.size() && joins(p)) return p;
    }
    return list.size();
  };
  const auto q = 2 * static_cast<std::size_t>(a);
  if (b < 0) return slots(q, [&](std::size_t p) { return list.j[p] == b; });
  const std::size_t own = slots(q, [&](std::size_t p) { return list.owner[p] == b; });
  return own < list.size() ? own : slots(q + 1, [&](std::size_t p) { return list.i[p] == b; });
}

}  // namespace

void carry_over(Sample& s, const ContactList& before, const std::vector<std::int32_t>& was, const Team& team) {
  ContactList& list = s.list;
  if (before.size() == 0 || (s.live_bonds.empty() && s.contact.friction_law != FrictionLaw::cundall_strack)) return;
  team.for_ranges(list.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const std::int32_t a = was[static_cast<std::size_t>(list.i[p])];
      const std::int32_t b = list.j[p] < 0 ? list.j[p] : was[static_cast<std::size_t>(list.owner[p])];
      const std::size_t old = find_slot(before, a, b);
      if (old == before.size()) continue;
      list.memory[p] = before.memory[old];
      list.bond[p] = before.bond[old];
    }
  });
}

}  // namespace arenite::dem
