#include "grains/dem/kernels/make_kernel.hpp"

namespace arenite::dem {

constinit const Kernel portable_kernel = make_kernel<2>("portable");
constinit const KernelIn<3> portable_sphere_kernel = make_kernel<2, 3>("portable");

}  // namespace arenite::dem
