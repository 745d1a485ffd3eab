#pragma once
#include <cstddef>

#include "model/packing.hpp"

namespace arenite::texture {

/// Mass of a grain by its material's density, kg; and of all.
double mass_of(const Packing& packing, std::size_t grain);
double mass_of(const PackingIn<3>& packing, std::size_t grain);
double mass_of(const Packing& packing);

}  // namespace arenite::texture
