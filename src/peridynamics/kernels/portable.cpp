#include <array>
#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "peridynamics/kernels/kernels.hpp"
#include "peridynamics/kernels/lanes_portable.hpp"
#include "peridynamics/kernels/stencil.hpp"
#include "peridynamics/kernels/passes.hpp"

namespace arenite::peridynamics {
extern const Kernels portable_kernels;
const Kernels portable_kernels = table_of("portable");
}  // namespace arenite::peridynamics
