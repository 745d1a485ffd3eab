#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Grains a and b (caller's indices) attract each other.
bool is_glued(const Sample& sample, std::int32_t a, std::int32_t b);

/// Decides anew which listed pairs attract, after glue was switched on or off. Where bonds break for good, the glued
/// pairs that touch now (to a millionth of their radii) are the bonds there are.
void bond_touching_pairs(Sample& sample);

}  // namespace arenite::dem
