#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// The grains' own masses, or even ones for a compaction; never with gravity. Even: every grain is as heavy as makes
/// its contacts as fast as those of the grain whose contacts are fastest, k/m alike, and all heavier where the step
/// needs it. A step that they do not allow is shortened, or refused (InputError) where it was given.
template <int D> void set_mass_scaling(SampleIn<D>& sample, MassScaling masses);

}  // namespace arenite::dem
