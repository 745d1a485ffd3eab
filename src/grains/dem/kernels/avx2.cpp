#include "grains/dem/kernels/make_kernel.hpp"

namespace arenite::dem {

constinit const Kernel avx2_kernel = make_kernel<4>("avx2");
constinit const KernelIn<3> avx2_sphere_kernel = make_kernel<4, 3>("avx2");

}  // namespace arenite::dem
