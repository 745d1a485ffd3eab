#pragma once
#include "solid/statics/discretisation.hpp"
#include "solid/voxels/couplings.hpp"
#include "solid/voxels/voxels.hpp"

namespace arenite::voxels {

using Kernels = statics::KernelsOf<Voxels>;

/// The kernels for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if it cannot run here.
/// "avx2" and "avx512" give the same bits, "portable" rounds products and sums apart.
const Kernels& kernels_of(const Voxels& voxels);
const Kernels* kernels_named(const char* name);

extern const Kernels avx2_kernels, avx512_kernels;

/// Adds what a voxel of some modes couples of two aggregates with parts in it.
struct CouplingKernel {
  const char* name;
  void (*couple)(const Modes&, const Part& p, const Part& q, statics::CouplingIn<3>& to);
};
const CouplingKernel& coupling_kernel();
extern const CouplingKernel avx2_coupling, avx512_coupling;

}  // namespace arenite::voxels
