#pragma once
#include "solid/elements/cell_products.hpp"
#include "solid/elements/couplings.hpp"
#include "solid/elements/elements.hpp"
#include "solid/statics/discretisation.hpp"

namespace arenite::elements {

template <int D> using KernelsIn = statics::KernelsOf<ElementsIn<D>>;

/// The kernels for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if it cannot run here.
/// "avx2" and "avx512" give the same bits, "portable" rounds products and sums apart.
template <int D> const KernelsIn<D>& kernels_of(const ElementsIn<D>& elements);
template <int D> const KernelsIn<D>* kernels_named(const char* name);

/// Adds what an element of some modes couples of two aggregates with parts in it.
template <int D>
using CouplingKernel = void (*)(const Modes<D>&, const Part<D>& p, const Part<D>& q, statics::CouplingIn<D>& to);
template <int D> CouplingKernel<D> coupling_kernel();

/// What one source compiles for its machine.
template <int D> struct Compiled {
  const char* name;
  KernelsIn<D> passes;
  CouplingKernel<D> couple;
  CellKernel couple_cell;  ///< in space
};
extern const Compiled<2> avx2_plane, avx512_plane;
extern const Compiled<3> avx2_space, avx512_space;

}  // namespace arenite::elements
