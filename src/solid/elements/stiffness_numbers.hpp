#pragma once
#include "solid/elements/effective_stiffness.hpp"
#include "statistics/numbers.hpp"

namespace arenite::elements {

/// Elements that carry, hang on one clamp, or float.
Numbers support_numbers(const statics::Support& support);

/// The stiffness, its Young's moduli, Poisson's ratios and shear moduli along the axes, the bounds of Voigt and Reuss
/// and of Hashin and Shtrikman, and how isotropic it is.
template <int D> Numbers stiffness_numbers(const EffectiveStiffness<D>& effective);

}  // namespace arenite::elements
