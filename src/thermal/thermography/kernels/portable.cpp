#include "core/processor.hpp"
#include "thermal/thermography/kernels/passes.hpp"

namespace arenite::thermography {
namespace {

constexpr Kernels portable = kernels_of<4>("portable");

KernelChoice<Kernels> choice() { return {portable, &avx2_kernels, &avx512_kernels}; }

}  // namespace

const Kernels* kernels(const char* name) { return choice().named(name); }

const Kernels& kernels() {
  static const Kernels& best = choice().best();
  return best;
}

}  // namespace arenite::thermography
