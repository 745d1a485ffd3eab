#include "solid/elements/kernels/sweep.hpp"

namespace arenite::elements {

constinit const Kernels avx512_kernels = statics::Passes<ElementSweep>::table(statics::Machine::name);

}  // namespace arenite::elements
