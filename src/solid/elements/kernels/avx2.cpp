#include "solid/elements/kernels/sweep.hpp"

namespace arenite::elements {

constinit const Kernels avx2_kernels = statics::Passes<ElementSweep>::table(statics::Machine::name);

}  // namespace arenite::elements
