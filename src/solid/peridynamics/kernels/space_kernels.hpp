#pragma once
#include <array>

#include "solid/peridynamics/space/bonds_in_space.hpp"
#include "solid/statics/discretisation.hpp"

namespace arenite::peridynamics {

/// The kernels of bonds in space for one machine, by their horizon: 2, 3.
struct SpaceKernelSet {
  const char* name;
  std::array<statics::KernelsOf<SpaceBonds>, 2> by_reach;
};

/// The kernels of a sample's horizon for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if
/// it cannot run here.
const statics::KernelsOf<SpaceBonds>& kernels_of(const SpaceBonds& bonds);
const statics::KernelsOf<SpaceBonds>* space_kernels_named(const char* name, int reach);

extern const SpaceKernelSet avx2_space_kernels, avx512_space_kernels;

}  // namespace arenite::peridynamics
