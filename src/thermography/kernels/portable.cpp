#include "thermography/kernels/kernels.hpp"
#include "thermography/kernels/lanes_one.hpp"

namespace {
using Floats = One<float>;
using Doubles = One<double>;
}  // namespace
#include "thermography/kernels/passes.inc"

namespace arenite::thermography {
extern const Kernels portable_kernels;
const Kernels portable_kernels = table_of("portable");
}  // namespace arenite::thermography
