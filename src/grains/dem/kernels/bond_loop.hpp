#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <variant>

#include "grains/dem/kernels/bond_pack.hpp"
#include "grains/dem/kernels/kernel.hpp"

namespace arenite::dem {

/// Forces of W bonds from p on. Notes which need a closer look: those that may break, and those that have turned far.
template <int W, bool damped, int D, class Law>
ARENITE_INLINE bool bond_batch(const BondTask<D>& t, const Law& law, std::size_t p) {
  const BondPack<W, D> bond(t, p);
  auto force = law.elastic(bond.beam, bond.strain);
  const auto look = ~law.holds(bond.beam, force, bond.strength) | bond.far;
  if constexpr (damped) force = force + bond.damping(t, p);
  bond.put(force, t.force + p);
  bool any = false;
  for (int k = 0; k < W; ++k) {
    t.look[p + static_cast<std::size_t>(k)] = look[k] != 0;
    any |= look[k] != 0;
  }
  return any;
}

template <int W, bool damped, int D, class Law>
__attribute__((flatten)) bool bond_range(const BondTask<D>& given, const Law& given_law, std::size_t begin,
                                         std::size_t end) {
  const BondTask<D> task = given;  // copies that no store can reach stay in registers
  const Law law = given_law;
  bool any = false;
  std::size_t p = begin;
  for (; p < end && p % W != 0; ++p) any |= bond_batch<1, damped>(task, law, p);
  for (; p + W <= end; p += W) any |= bond_batch<W, damped>(task, law, p);
  for (; p < end; ++p) any |= bond_batch<1, damped>(task, law, p);
  return any;
}

/// Bonds begin .. end-1. True if some need a closer look.
template <int W, int D, class Law>
bool bond_loop(const BondTask<D>& task, const BondLaw& choice, std::size_t begin, std::size_t end) {
  const Law& law = *std::get_if<Law>(&choice);
  return task.damped ? bond_range<W, true>(task, law, begin, end) : bond_range<W, false>(task, law, begin, end);
}

/// The loops of all bond laws.
template <int W, int D, std::size_t... Q>
constexpr std::array<typename KernelIn<D>::BondLoop, sizeof...(Q)> bond_loops(std::index_sequence<Q...>) {
  return {bond_loop<W, D, std::variant_alternative_t<Q, BondLaw::variant>>...};
}

}  // namespace arenite::dem
