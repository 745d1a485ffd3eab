#include <array>
#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "peridynamics/kernels/kernels.hpp"
#include "peridynamics/kernels/lanes_portable.hpp"
#include "peridynamics/kernels/stencil.inc"
#include "peridynamics/kernels/passes.inc"

namespace arenite::peridynamics {
extern const Kernels portable_kernels;
const Kernels portable_kernels = table_of("portable");
}  // namespace arenite::peridynamics
