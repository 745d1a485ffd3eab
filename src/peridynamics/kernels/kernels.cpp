#include "peridynamics/kernels/kernels.hpp"

#include <string_view>

namespace arenite::peridynamics {

extern const Kernels portable_kernels;
extern const Kernels* const avx2_kernels;  ///< null where the compiler cannot make them

namespace {

bool machine_has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

}  // namespace

const Kernels* kernels(const char* name) {
  if (std::string_view(name) == portable_kernels.name) return &portable_kernels;
  if (avx2_kernels && std::string_view(name) == avx2_kernels->name && machine_has_avx2()) return avx2_kernels;
  return nullptr;
}

const Kernels& kernels() {
  const Kernels* const best = kernels("avx2");
  return best ? *best : portable_kernels;
}

}  // namespace arenite::peridynamics
