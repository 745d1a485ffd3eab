#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/parameters.hpp"
#include "solid/peridynamics/lattice.hpp"

namespace arenite::peridynamics {

/// A parameter of a bond law, one value for each type of bond.
struct LawParameter {
  std::string_view name, unit, sentence;
  Range range;
};

/// A bond pulls in proportion to its stretch s = (|xi + eta| - |xi|)/|xi| (P eq. 4), f = c s along the bond (P eq. 6 and 7), and breaks for good where
/// s reaches the critical stretch.
struct ElasticBrittle {
  static constexpr std::string_view name = "elastic-brittle";
  static constexpr LawParameter young{"Young modulus", "Pa", "Young's modulus of the material that such bonds make up.", range::positive};
  static constexpr LawParameter toughness{"toughness", "Pa m^0.5", "Fracture toughness K, of the energy K^2/E that a crack takes.", range::positive};
  static constexpr std::array parameters{young, toughness};

  /// Force along the bond at an extension; `modulus` is force over extension.
  template <class V> [[gnu::always_inline]] inline V force(V extension, V modulus) const { return modulus * extension; }
  /// Work done on the way to an extension: the integral of `force`.
  double energy(double extension, double modulus) const { return modulus * extension * extension / 2; }
  /// How near a bond is to breaking, 1 where it breaks. Stretch only breaks it.
  double damage(double stretch, double critical) const { return stretch / critical; }
  /// The stretch at which a bond breaks, so that a crack takes the energy G = K^2/E: sqrt(4 pi G/(9 E h)), h = 3 dx, plane stress.
  double critical_stretch(double k, double e, double dx) const { return k / e * std::sqrt(4 * std::numbers::pi / (9 * horizon * dx)); }
};

}  // namespace arenite::peridynamics
