#include <array>
#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "solid/peridynamics/kernels/kernels.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include "solid/peridynamics/kernels/lanes_avx512.hpp"
#include "solid/peridynamics/kernels/stencil.inc"
#include "solid/peridynamics/kernels/passes.inc"

namespace arenite::peridynamics {
extern const Kernels* const avx512_kernels;
namespace {
const Kernels table = table_of("avx512");
}
const Kernels* const avx512_kernels = &table;
}  // namespace arenite::peridynamics
#else
namespace arenite::peridynamics {
extern const Kernels* const avx512_kernels;
const Kernels* const avx512_kernels = nullptr;
}  // namespace arenite::peridynamics
#endif
