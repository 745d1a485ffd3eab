#include "thermal/thermography/kernels/passes.hpp"

namespace arenite::thermography {

constinit const Kernels avx2_kernels = kernels_of<8>("avx2");

}  // namespace arenite::thermography
