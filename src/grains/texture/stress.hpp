#pragma once
#include <vector>

#include "core/tensor.hpp"
#include "model/packing.hpp"

/// Moments and stresses of grains by their contacts, bonds and pulls across gaps.
namespace arenite::texture {

/// Internal moment of every grain about its centre, N m (T eq. 1.9). Their sum is the sum over contacts, bonds and
/// pulls across gaps.
template <int D> std::vector<Tensor<D>> grain_moments(const PackingIn<D>& packing);
/// Mean stress of every grain over its own volume, Pa, tension positive (T eq. 1.11).
template <int D> std::vector<Tensor<D>> grain_stresses(const PackingIn<D>& packing);
/// p of a stress, the mean of its principal values, positive in compression.
template <class AnyTensor> double pressure(const AnyTensor& stress) { return -mean_principal(stress); }
/// Of the symmetric part: in the plane half the difference of the principal values, in space sqrt(3 J_2), in a triaxial
/// test their difference.
double deviator(const Tensor2& stress);
double deviator(const Tensor3& stress);

}  // namespace arenite::texture
