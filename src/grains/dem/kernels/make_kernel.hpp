#pragma once
#include <utility>

#include "grains/dem/kernels/bond_loop.hpp"
#include "grains/dem/kernels/pair_loop.hpp"
#include "grains/dem/kernels/sweep.hpp"

namespace arenite::dem {

/// The loops of all triples of laws, in the order of loop_index.
template <int W, std::size_t... Q> constexpr std::array<Kernel::PairLoop, law_triples> pair_loops(std::index_sequence<Q...>) {
  return {pair_loop<W, std::variant_alternative_t<Q / friction_laws / adhesions, NormalLaw::variant>,
                    std::variant_alternative_t<Q / friction_laws % adhesions, Adhesion::variant>,
                    std::variant_alternative_t<Q % friction_laws, FrictionLaw::variant>>...};
}

/// All loops for W contacts or disks at a time.
template <int W> constexpr Kernel make_kernel(const char* name) {
  return {name, pair_loops<W>(std::make_index_sequence<law_triples>{}), sweep<W, VerletBatch>, sweep<W, GearBatch>, bond_loop<W>};
}

}  // namespace arenite::dem
