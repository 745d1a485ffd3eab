#pragma once
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/kernels/bond_loop.hpp"
#include "grains/dem/kernels/pair_loop.hpp"
#include "grains/dem/kernels/rolling_loop.hpp"

namespace arenite::dem {

/// All loops for W contacts and disks, or spheres, at a time.
template <int W, int D = 2> constexpr KernelIn<D> make_kernel(const char* name) {
  return {name, pair_loops<W, D>(std::make_index_sequence<law_triples>{}),
          sweeps<W, D>(std::make_index_sequence<integrator_count>{}),
          bond_loops<W, D>(std::make_index_sequence<bond_laws>{}),
          rolling_loops<W, D>(std::make_index_sequence<rolling_laws>{})};
}

}  // namespace arenite::dem
