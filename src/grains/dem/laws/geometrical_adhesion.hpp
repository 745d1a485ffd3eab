#pragma once
#include "grains/dem/laws/lane.hpp"

namespace arenite::dem {

/// No attraction: what most samples use, and nothing is computed for it.
struct NoAdhesion {
  template <class V>
  V attraction(V /*h*/, V /*strength*/) const { return V(0.0); }
  template <class V>
  V energy(V /*h*/, V /*strength*/) const { return V(0.0); }
  template <class V>
  V cap_shift(V /*pull_off*/) const { return V(0.0); }
};

/// Geometrical adhesion, an attraction gamma sqrt(r_eff h) while two glued grains touch (T eq. 1.22-1.25).
/// `strength` = gamma sqrt(r_eff), 0 for a pair that is not glued.
struct GeometricalAdhesion {
  double cap_sign = 1;  ///< the friction cap is mu (F_n + cap_sign |F_c|): 1 raised by adhesion, -1 as T (1.28) is printed

  /// >= 0; pulls the grains together.
  template <class V>
  V attraction(V h, V strength) const {
    using lane::sqrt;
    return strength * sqrt(h);
  }
  /// Potential of the attraction, <= 0, 0 at h = 0.
  template <class V>
  V energy(V h, V strength) const {
    using lane::sqrt;
    return V(-2.0 / 3.0) * strength * h * sqrt(h);
  }
  /// What the pull-off force F_c > 0 of the pair, which the normal law knows, adds to F_n in the friction cap.
  template <class V>
  V cap_shift(V pull_off) const {
    return V(cap_sign) * pull_off;
  }
};

}  // namespace arenite::dem
