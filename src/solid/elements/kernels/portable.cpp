#include "core/processor.hpp"
#include "solid/elements/kernels/couple.hpp"
#include "solid/elements/kernels/plane_sweep.hpp"
#include "solid/elements/kernels/space_sweep.hpp"

namespace arenite::elements {
namespace {

constexpr Compiled<2> portable_plane = compiled<2, PlaneSweep>();
constexpr Compiled<3> portable_space = compiled<3, SpaceSweep>();

template <int D> KernelChoice<Compiled<D>> choice();
template <> KernelChoice<Compiled<2>> choice<2>() { return {portable_plane, &avx2_plane, &avx512_plane}; }
template <> KernelChoice<Compiled<3>> choice<3>() { return {portable_space, &avx2_space, &avx512_space}; }

template <int D> const Compiled<D>& best() {
  static const Compiled<D>& here = choice<D>().best();
  return here;
}

}  // namespace

template <int D> const KernelsIn<D>* kernels_named(const char* name) {
  const Compiled<D>* const found = choice<D>().named(name);
  return found ? &found->passes : nullptr;
}
template <int D> const KernelsIn<D>& kernels_of(const ElementsIn<D>&) { return best<D>().passes; }
template <int D> CouplingKernel<D> coupling_kernel() { return best<D>().couple; }
CellKernel cell_kernel() { return best<3>().couple_cell; }

template const KernelsIn<2>* kernels_named<2>(const char* name);
template const KernelsIn<3>* kernels_named<3>(const char* name);
template const KernelsIn<2>& kernels_of(const Elements& elements);
template const KernelsIn<3>& kernels_of(const Voxels& elements);
template CouplingKernel<2> coupling_kernel<2>();
template CouplingKernel<3> coupling_kernel<3>();

}  // namespace arenite::elements
