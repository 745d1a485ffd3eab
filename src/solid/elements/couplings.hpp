#pragma once
#include <cstdint>
#include <cstring>
#include <vector>

#include "solid/elements/elements.hpp"
#include "solid/statics/couplings.hpp"

namespace arenite::elements {

/// Amplitudes of the hats of one aggregate on one element, for a component: [mode][hat].
template <int D> struct Part {
  using Hatwise = double[mode_count<D>][statics::corners<D>];
  Hatwise along, across;  ///< the clamps: in their plane; the last component

  void clear() { std::memset(this, 0, sizeof *this); }
  void add(const statics::HatsIn<D>& hats, int corner, bool slides) {
    for (int m = 1; m < mode_count<D>; ++m) {
      const double sign = sign_of(m, corner);
      for (int hat = 0; hat < statics::corners<D>; ++hat) {
        along[m][hat] += sign * hats[hat];
        if (!slides) across[m][hat] += sign * hats[hat];
      }
    }
  }
  ARENITE_INLINE const Hatwise& of(int component) const { return component == D - 1 ? across : along; }
};

/// Galerkin sums over all elements, in double, one level of coarse cells after the other. In a bottom level that
/// slides, hats move nodes across the clamps by nothing. `elements` is asked again when the sums are.
template <int D>
statics::GalerkinSums<D> couplings(const ElementsIn<D>& elements, const Aggregates& aggregates,
                                   BlockDiagonalIn<D, double> diagonal, const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::elements
