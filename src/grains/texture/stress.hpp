#pragma once
#include <vector>

#include "core/vec.hpp"
#include "model/packing.hpp"

/// Moments and stresses of grains by their contacts, bonds and pulls across gaps.
namespace arenite::texture {

/// Internal moment of every grain about its centre, N m (T eq. 1.9). Their sum is the sum over contacts, bonds and
/// pulls across gaps.
std::vector<Tensor2> grain_moments(const Packing& packing);
/// Mean stress of every grain over its own volume, Pa, tension positive (T eq. 1.11).
std::vector<Tensor2> grain_stresses(const Packing& packing);
/// p of a stress, half its trace, positive in compression.
double pressure(const Tensor2& stress);
/// Half the difference of the principal values, of the symmetric part.
double deviator(const Tensor2& stress);

}  // namespace arenite::texture
