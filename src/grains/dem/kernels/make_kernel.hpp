#pragma once
#include "grains/dem/kernels/bond_loop.hpp"
#include "grains/dem/kernels/pair_loop.hpp"
#include "grains/dem/kernels/sweep.hpp"

namespace arenite::dem {

/// All loops for W contacts or disks at a time.
template <int W> constexpr Kernel make_kernel(const char* name) {
  return {name, pair_loops<W>(std::make_index_sequence<law_triples>{}), sweep<W, VerletBatch>, sweep<W, GearBatch>,
          bond_loops<W>(std::make_index_sequence<bond_laws>{})};
}

}  // namespace arenite::dem
