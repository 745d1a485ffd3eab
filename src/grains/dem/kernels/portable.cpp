#include "grains/dem/kernels/make_kernel.hpp"

namespace arenite::dem {

constinit const Kernel portable_kernel = make_kernel<2>("portable");

}  // namespace arenite::dem
