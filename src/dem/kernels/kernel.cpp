#include "dem/kernels/kernel.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace arenite::dem {

namespace {

struct Choice {
  const Kernel& kernel;
  bool runs_here;
};

}  // namespace

const Kernel& find_kernel(const std::string& asked) {
  const Choice choices[] = {  // widest first
      {avx512_kernel, __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")},
      {avx2_kernel, __builtin_cpu_supports("avx2") != 0},
      {portable_kernel, true},
  };
  for (const auto& [kernel, runs_here] : choices) {
    if (asked == "auto" && runs_here) return kernel;
    if (asked != kernel.name) continue;
    if (!runs_here)
      throw InputError(fmt::format("kernel \"{}\" needs a processor that this machine lacks; \"auto\" takes the best it has",
                                   asked));
    return kernel;
  }
  throw InputError(fmt::format("kernel \"{}\" is none of auto, portable, avx2, avx512", asked));
}

}  // namespace arenite::dem
