#pragma once
#include <vector>

#include "model/packing.hpp"

namespace arenite::texture {

/// Sum over contacts, walls included, of f (x) l, with f on grain i and l from i to j (or to the wall), N m. Divided by
/// the volume of the box it is the stress, tension positive (T eq. 1.10).
Tensor2 internal_moment(const Contacts& contacts);

/// Internal moment of every grain about its centre, N m (T eq. 1.9). Their sum is the sum over contacts.
std::vector<Tensor2> grain_moments(const Packing& packing);

/// Mass of a grain by its material's density, kg.
double mass_of(const Packing& packing, std::size_t grain);

/// What the internal moment must be at rest by the forces on walls and by weight: sum over wall contacts of
/// f (x) x_c plus sum over grains of m g (x) x.
Tensor2 wall_moment(const Packing& packing, Vec2 gravity);

}  // namespace arenite::texture
