#include "thermal/thermography/kernels/passes.hpp"

namespace arenite::thermography {

constinit const Kernels avx512_kernels = kernels_of<16>("avx512");

}  // namespace arenite::thermography
