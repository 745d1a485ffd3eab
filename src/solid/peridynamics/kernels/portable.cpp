#include "core/processor.hpp"
#include "solid/peridynamics/kernels/stencil.hpp"

namespace arenite::peridynamics {
namespace {

constexpr KernelSet portable = kernel_set();

KernelChoice<KernelSet> choice() { return {portable, &avx2_kernels, &avx512_kernels}; }

}  // namespace

const Kernels* kernels(const char* name, const BondLawChoice& law) {
  const KernelSet* set = choice().named(name);
  return set ? &set->by_law[law.index()] : nullptr;
}

const Kernels& kernels(const BondLawChoice& law) {
  static const KernelSet& best = choice().best();
  return best.by_law[law.index()];
}

}  // namespace arenite::peridynamics
