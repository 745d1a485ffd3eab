#pragma once
#include <cstddef>

#include "model/packing.hpp"

namespace arenite {

/// Calls see(i, j, force on i, way from j to i) for what joins two grains beside their contacts: bonds that hold, and
/// pulls across gaps; N and m.
template <int D, class See> void for_each_joint(const PackingIn<D>& packing, const See& see) {
  const auto show = [&](const auto& link) {
    see(static_cast<std::size_t>(link.i), static_cast<std::size_t>(link.j), force_on_i(packing, link),
        branch_of(packing, link));
  };
  for (const BondIn<D>& bond : packing.bonds)
    if (bond.broken == BondBreak::none) show(bond);
  for (const CohesivePair& pair : packing.cohesive)
    if (acts_across_gap(pair)) show(pair);
}

}  // namespace arenite
