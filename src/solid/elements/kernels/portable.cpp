#include "core/processor.hpp"
#include "solid/elements/kernels/sweep.hpp"

namespace arenite::elements {
namespace {

constexpr Kernels portable = statics::Passes<ElementSweep>::table(statics::Machine::name);

KernelChoice<Kernels> choice() { return {portable, &avx2_kernels, &avx512_kernels}; }

}  // namespace

const Kernels* kernels_named(const char* name) { return choice().named(name); }

const Kernels& kernels_of(const Elements&) {
  static const Kernels& best = choice().best();
  return best;
}

}  // namespace arenite::elements
