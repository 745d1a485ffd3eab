#include "solid/voxels/kernels/couple.hpp"
#include "solid/voxels/kernels/sweep.hpp"

namespace arenite::voxels {

constinit const Kernels avx2_kernels = statics::Passes<VoxelSweep>::table(statics::Machine::name);
constinit const CouplingKernel avx2_coupling{statics::Machine::name, couple};

}  // namespace arenite::voxels
