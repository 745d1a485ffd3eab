#include "thermography/kernels/kernels.hpp"

#include <string_view>

namespace arenite::thermography {

extern const Kernels portable_kernels;
extern const Kernels* const avx2_kernels;  ///< null where the compiler cannot make them
extern const Kernels* const avx512_kernels;

namespace {

bool machine_has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

bool machine_has_avx512() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#else
  return false;
#endif
}

}  // namespace

const Kernels* kernels(const char* name) {
  if (std::string_view(name) == portable_kernels.name) return &portable_kernels;
  if (avx2_kernels && std::string_view(name) == avx2_kernels->name && machine_has_avx2()) return avx2_kernels;
  if (avx512_kernels && std::string_view(name) == avx512_kernels->name && machine_has_avx512()) return avx512_kernels;
  return nullptr;
}

const Kernels& kernels() {
  static const Kernels& best = []() -> const Kernels& {
    for (const char* name : {"avx512", "avx2"})
      if (const Kernels* k = kernels(name)) return *k;
    return portable_kernels;
  }();
  return best;
}

}  // namespace arenite::thermography
