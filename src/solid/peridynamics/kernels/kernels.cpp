#include "solid/peridynamics/kernels/kernels.hpp"
#include "core/processor.hpp"

namespace arenite::peridynamics {

extern const KernelSet portable_kernels;
extern const KernelSet* const avx2_kernels;  ///< null where the compiler cannot make them
extern const KernelSet* const avx512_kernels;

namespace {

KernelChoice<KernelSet> choice() { return {portable_kernels, avx2_kernels, avx512_kernels}; }

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
