#include <array>
#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "solid/peridynamics/kernels/kernels.hpp"
#include "solid/peridynamics/kernels/lanes_portable.hpp"
#include "solid/peridynamics/kernels/stencil.inc"
#include "solid/peridynamics/kernels/passes.inc"

namespace arenite::peridynamics {
extern const Kernels portable_kernels;
const Kernels portable_kernels = table_of("portable");
}  // namespace arenite::peridynamics
