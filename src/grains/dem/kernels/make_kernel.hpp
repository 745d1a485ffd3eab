#pragma once
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/kernels/bond_loop.hpp"
#include "grains/dem/kernels/pair_loop.hpp"

namespace arenite::dem {

/// All loops for W contacts or disks at a time.
template <int W> constexpr Kernel make_kernel(const char* name) {
  return {name, pair_loops<W>(std::make_index_sequence<law_triples>{}), sweeps<W>(std::make_index_sequence<integrator_count>{}),
          bond_loops<W>(std::make_index_sequence<bond_laws>{})};
}

}  // namespace arenite::dem
