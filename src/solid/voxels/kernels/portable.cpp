#include "core/processor.hpp"
#include "solid/voxels/kernels/couple.hpp"
#include "solid/voxels/kernels/sweep.hpp"

namespace arenite::voxels {
namespace {

constexpr Kernels portable = statics::Passes<VoxelSweep>::table(statics::Machine::name);

constexpr CouplingKernel portable_coupling{statics::Machine::name, couple};

KernelChoice<Kernels> choice() { return {portable, &avx2_kernels, &avx512_kernels}; }

}  // namespace

const Kernels* kernels_named(const char* name) { return choice().named(name); }

const Kernels& kernels_of(const Voxels&) {
  static const Kernels& best = choice().best();
  return best;
}

const CouplingKernel& coupling_kernel() {
  static const CouplingKernel& best =
      KernelChoice<CouplingKernel>{portable_coupling, &avx2_coupling, &avx512_coupling}.best();
  return best;
}

}  // namespace arenite::voxels
