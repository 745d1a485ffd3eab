#pragma once
#include <cstdint>

#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Goes on by so many steps. After the last one the forces of a cell's edges are known, too.
template <int D> void advance(SampleIn<D>& sample, const ThreadPool& pool, std::int64_t steps);

/// Forces of all listed contacts from the records (whose ghosts are fresh), into the list's slots; then the forces of
/// the walls. Springs of the friction law move on by one step.
template <int D> void compute_forces(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// Forces of the edges of a periodic cell, the means over all its cuts: of those across x (1/W) sum f l_x. Not part of
/// compute_forces, because only driven edges and readers need them.
template <int D> void sum_edge_forces(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

}  // namespace arenite::dem
