#include "grains/dem/kernels/kernel.hpp"

#include <fmt/core.h>

#include "core/error.hpp"
#include "core/processor.hpp"

namespace arenite::dem {

namespace {

template <int D> KernelChoice<KernelIn<D>> kernels();
template <> KernelChoice<Kernel> kernels() { return {portable_kernel, &avx2_kernel, &avx512_kernel}; }
template <> KernelChoice<KernelIn<3>> kernels() {
  return {portable_sphere_kernel, &avx2_sphere_kernel, &avx512_sphere_kernel};
}

}  // namespace

template <int D> const KernelIn<D>& find_kernel(const std::string& asked) {
  const auto choice = kernels<D>();
  if (asked == "auto") return choice.best();
  if (const KernelIn<D>* kernel = choice.named(asked)) return *kernel;
  if (asked == avx2_kernel.name || asked == avx512_kernel.name)
    throw InputError(
        fmt::format("kernel \"{}\" is not supported by this processor; \"auto\" chooses the best one", asked));
  throw InputError(fmt::format("kernel \"{}\" is not one of auto, portable, avx2, avx512", asked));
}

template const Kernel& find_kernel(const std::string&);
template const KernelIn<3>& find_kernel(const std::string&);

}  // namespace arenite::dem
