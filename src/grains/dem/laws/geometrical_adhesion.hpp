#pragma once
#include "grains/dem/laws/parts.hpp"

namespace arenite::dem {

/// No attraction: what most samples use, and nothing is computed for it.
struct NoAdhesion : NoLaw {
  static constexpr Word word{"none", "no glue"};
  static constexpr bool attracts = false, breaks = false;

  template <class V> V attraction(V /*h*/, V /*strength*/) const { return V(0.0); }
  template <class V> V energy(V /*h*/, V /*strength*/) const { return V(0.0); }
};

/// Geometrical adhesion, an attraction gamma sqrt(r_eff h) while two glued grains touch (T eq. 1.22-1.25). `strength` =
/// gamma sqrt(r_eff), 0 for a pair that is not glued.
struct GeometricalAdhesion : WithoutParameters {
  static constexpr Word word{"geometrical", "-gamma sqrt(r_eff h), reversible"};
  static constexpr bool attracts = true, breaks = false;

  template <class V> V attraction(V h, V strength) const {
    using lane::sqrt;
    return strength * sqrt(h);
  }
  template <class V> V energy(V h, V strength) const {
    using lane::sqrt;
    return V(-2.0 / 3.0) * strength * h * sqrt(h);
  }
};

/// The same force; glue whose contact has opened is gone for good.
struct BreakingAdhesion : GeometricalAdhesion {
  static constexpr Word word{"geometrical_breaking", "the same, lost for good once a contact opens"};
  static constexpr bool breaks = true;
  bool operator==(const BreakingAdhesion&) const = default;
};

}  // namespace arenite::dem
