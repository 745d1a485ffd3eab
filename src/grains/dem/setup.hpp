#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Checks the input, sorts the disks or spheres, lists the contacts, chooses the step and evaluates the first forces.
/// Throws InputError, every problem in one pass, for input that makes no sense and for a step beyond the bounds.
template <int D>
SampleIn<D> make_sample(const PackingIn<D>& start, const ContactParameters& contact,
                        const IntegrationParameters& integration, const KernelIn<D>& kernel);

}  // namespace arenite::dem
