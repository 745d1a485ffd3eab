#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Adds the moments of rolling resistance to the slots' torques.
template <int D> void add_rolling_moments(SampleIn<D>& sample, const ThreadPool& pool);
/// What the rolling springs hold, J.
template <int D> double rolling_energy(const SampleIn<D>& sample);

}  // namespace arenite::dem
