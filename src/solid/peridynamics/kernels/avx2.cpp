#include "solid/peridynamics/kernels/space_stencil.hpp"
#include "solid/peridynamics/kernels/stencil.hpp"

namespace arenite::peridynamics {

constinit const KernelSet avx2_kernels = kernel_set();
constinit const SpaceKernelSet avx2_space_kernels = space_kernel_set();

}  // namespace arenite::peridynamics
