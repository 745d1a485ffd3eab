#include <array>
#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "solid/peridynamics/kernels/kernels.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include "solid/peridynamics/kernels/lanes_avx2.hpp"
#include "solid/peridynamics/kernels/stencil.inc"
#include "solid/peridynamics/kernels/passes.inc"

namespace arenite::peridynamics {
extern const Kernels* const avx2_kernels;
namespace {
const Kernels table = table_of("avx2");
}
const Kernels* const avx2_kernels = &table;
}  // namespace arenite::peridynamics
#else
namespace arenite::peridynamics {
extern const Kernels* const avx2_kernels;
const Kernels* const avx2_kernels = nullptr;
}  // namespace arenite::peridynamics
#endif
