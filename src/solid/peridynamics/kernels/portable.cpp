#include "core/processor.hpp"
#include "solid/peridynamics/kernels/space_stencil.hpp"
#include "solid/peridynamics/kernels/stencil.hpp"

namespace arenite::peridynamics {
namespace {

constexpr KernelSet portable = kernel_set();
constexpr SpaceKernelSet portable_space = space_kernel_set();

KernelChoice<KernelSet> choice() { return {portable, &avx2_kernels, &avx512_kernels}; }
KernelChoice<SpaceKernelSet> space_choice() { return {portable_space, &avx2_space_kernels, &avx512_space_kernels}; }

}  // namespace

const Kernels* kernels(const char* name, const BondLawChoice& law) {
  const KernelSet* set = choice().named(name);
  return set ? &set->by_law[law.index()] : nullptr;
}

const Kernels& kernels(const BondLawChoice& law) {
  static const KernelSet& best = choice().best();
  return best.by_law[law.index()];
}

const statics::KernelsOf<SpaceBonds>* space_kernels_named(const char* name, int reach) {
  const SpaceKernelSet* set = space_choice().named(name);
  return set ? &set->by_reach[reach == 2 ? 0 : 1] : nullptr;
}

const statics::KernelsOf<SpaceBonds>& kernels_of(const SpaceBonds& bonds) {
  static const SpaceKernelSet& best = space_choice().best();
  return best.by_reach[bonds.reach == 2 ? 0 : 1];
}

}  // namespace arenite::peridynamics
