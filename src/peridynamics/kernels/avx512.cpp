#include <array>
#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "peridynamics/kernels/kernels.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include "peridynamics/kernels/lanes_avx512.hpp"
#include "peridynamics/kernels/stencil.inc"
#include "peridynamics/kernels/passes.inc"

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
