#include "thermal/thermography/kernels/kernels.hpp"
#include "thermal/thermography/kernels/lanes_one.hpp"

namespace {
using Floats = One<float>;
using Doubles = One<double>;
}  // namespace
#include "thermal/thermography/kernels/passes.inc"

namespace arenite::thermography {
extern const Kernels portable_kernels;
const Kernels portable_kernels = table_of("portable");
}  // namespace arenite::thermography
