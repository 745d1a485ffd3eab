#pragma once
#include <string_view>

namespace arenite {

/// What the vector kernels ask of the processor: AVX2 with fused multiply-add; AVX-512 F, DQ and VL.
inline bool machine_has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
inline bool machine_has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

/// One set of inner loops, compiled for several processors. Those that the compiler cannot make are null.
template <class Kernels> struct KernelChoice {
  const Kernels& portable;
  const Kernels* avx2;
  const Kernels* avx512;

  /// The set of that name; null where there is none, or this machine cannot run it.
  const Kernels* named(std::string_view name) const {
    if (name == portable.name) return &portable;
    if (avx2 && name == avx2->name && machine_has_avx2()) return avx2;
    if (avx512 && name == avx512->name && machine_has_avx512()) return avx512;
    return nullptr;
  }
  /// The widest that this machine runs.
  const Kernels& best() const {
    if (avx512 && machine_has_avx512()) return *avx512;
    return avx2 && machine_has_avx2() ? *avx2 : portable;
  }
};

}  // namespace arenite
