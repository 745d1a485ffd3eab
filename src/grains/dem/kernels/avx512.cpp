#include "grains/dem/kernels/make_kernel.hpp"

namespace arenite::dem {

constinit const Kernel avx512_kernel = make_kernel<8>("avx512");
constinit const KernelIn<3> avx512_sphere_kernel = make_kernel<8, 3>("avx512");

}  // namespace arenite::dem
