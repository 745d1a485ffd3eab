#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Whether the law of rolling also brakes grains that turn about the line between them, which disks cannot.
inline bool resists_twisting(const Sample& /*sample*/) { return false; }
inline bool resists_twisting(const SampleIn<3>& sample) {
  return sample.contact.rolling.visit([](const auto& law) { return law.twisting > 0; });
}

/// Adds the moments of resistance to rolling and twisting to the slots' torques.
template <int D> void add_rolling_moments(SampleIn<D>& sample, const ThreadPool& pool);
/// What the springs of both hold, J.
template <int D> double rolling_energy(const SampleIn<D>& sample);

}  // namespace arenite::dem
