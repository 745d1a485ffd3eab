#include "thermal/thermography/kernels/kernels.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include "thermal/thermography/kernels/lanes_avx512.hpp"
#include "thermal/thermography/kernels/lanes_one.hpp"
#include "thermal/thermography/kernels/passes.inc"

namespace arenite::thermography {
extern const Kernels* const avx512_kernels;
namespace {
const Kernels table = table_of("avx512");
}
const Kernels* const avx512_kernels = &table;
}  // namespace arenite::thermography
#else
namespace arenite::thermography {
extern const Kernels* const avx512_kernels;
const Kernels* const avx512_kernels = nullptr;
}  // namespace arenite::thermography
#endif
