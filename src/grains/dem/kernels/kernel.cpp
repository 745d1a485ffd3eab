#include "grains/dem/kernels/kernel.hpp"

#include <fmt/core.h>

#include "core/error.hpp"
#include "core/processor.hpp"

namespace arenite::dem {

const Kernel& find_kernel(const std::string& asked) {
  const KernelChoice<Kernel> choice{portable_kernel, &avx2_kernel, &avx512_kernel};
  if (asked == "auto") return choice.best();
  if (const Kernel* kernel = choice.named(asked)) return *kernel;
  if (asked == avx2_kernel.name || asked == avx512_kernel.name)
    throw InputError(
        fmt::format("kernel \"{}\" is not supported by this processor; \"auto\" chooses the best one", asked));
  throw InputError(fmt::format("kernel \"{}\" is not one of auto, portable, avx2, avx512", asked));
}

}  // namespace arenite::dem
