#pragma once
#include "solid/elements/couplings.hpp"
#include "solid/elements/elements.hpp"
#include "solid/statics/discretisation.hpp"

namespace arenite::elements {

using Kernels = statics::KernelsOf<Elements>;

/// The kernels for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if it cannot run here.
/// "avx2" and "avx512" give the same bits, "portable" rounds products and sums apart.
const Kernels& kernels_of(const Elements& elements);
const Kernels* kernels_named(const char* name);

extern const Kernels avx2_kernels, avx512_kernels;

}  // namespace arenite::elements
