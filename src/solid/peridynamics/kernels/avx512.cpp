#include "solid/peridynamics/kernels/stencil.hpp"

namespace arenite::peridynamics {

constinit const KernelSet avx512_kernels = kernel_set();

}  // namespace arenite::peridynamics
