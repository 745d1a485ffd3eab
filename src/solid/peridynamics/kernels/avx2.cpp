#include "solid/peridynamics/kernels/stencil.hpp"

namespace arenite::peridynamics {

constinit const KernelSet avx2_kernels = kernel_set();

}  // namespace arenite::peridynamics
