#pragma once
#include <vector>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// How the domain's boundaries move from now on; InputError for a name that none has.
template <int D>
void set_boundaries(SampleIn<D>& sample, const std::vector<BoundaryMotionIn<D>>& motions,
                    const ThreadPool& pool = ThreadPool());
inline void set_boundaries(Sample& sample, const std::vector<BoundaryMotion>& motions,
                           const ThreadPool& pool = ThreadPool()) {
  set_boundaries<2>(sample, motions, pool);
}

/// Throws InputError for sides of a periodic cell that are driven, or sheared, where there are boundaries, which stay
/// as they are.
template <int D> void check_still_cell(const SampleIn<D>& sample, const WallDrivesIn<D>& drives, bool sheared);

}  // namespace arenite::dem
