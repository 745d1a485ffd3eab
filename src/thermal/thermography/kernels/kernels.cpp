#include "thermal/thermography/kernels/kernels.hpp"

#include "core/processor.hpp"

namespace arenite::thermography {

extern const Kernels portable_kernels;
extern const Kernels* const avx2_kernels;  ///< null where the compiler cannot make them
extern const Kernels* const avx512_kernels;

namespace {

KernelChoice<Kernels> choice() { return {portable_kernels, avx2_kernels, avx512_kernels}; }

}  // namespace

const Kernels* kernels(const char* name) { return choice().named(name); }

const Kernels& kernels() {
  static const Kernels& best = choice().best();
  return best;
}

}  // namespace arenite::thermography
