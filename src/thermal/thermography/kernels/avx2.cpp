#include "thermal/thermography/kernels/kernels.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include "thermal/thermography/kernels/lanes_avx2.hpp"
#include "thermal/thermography/kernels/lanes_one.hpp"
#include "thermal/thermography/kernels/passes.inc"

namespace arenite::thermography {
extern const Kernels* const avx2_kernels;
namespace {
const Kernels table = table_of("avx2");
}
const Kernels* const avx2_kernels = &table;
}  // namespace arenite::thermography
#else
namespace arenite::thermography {
extern const Kernels* const avx2_kernels;
const Kernels* const avx2_kernels = nullptr;
}  // namespace arenite::thermography
#endif
