#pragma once
#include <cmath>
#include <numbers>

#include "core/parameters.hpp"
#include "solid/peridynamics/lattice.hpp"
#include "solid/peridynamics/space/lattice_in_space.hpp"

namespace arenite::peridynamics {

/// A bond pulls in proportion to its stretch s = (|xi + eta| - |xi|)/|xi| (P eq. 4), f = c s along the bond (P eq. 6
/// and 7), and breaks for good where s reaches the critical stretch. Then it pulls no more; where its ends come nearer
/// than they were at first, the faces of the crack press on each other, and it pushes as a whole one does.
struct ElasticBrittle {
  static constexpr Word word{
      "elastic_brittle", "Force in proportion to the stretch, up to a critical one at which the bond breaks for good."};
  void declare(ParameterVisitor&) {}
  bool operator==(const ElasticBrittle&) const = default;

  /// Force along the bond at an extension; `modulus` is force over extension.
  template <class V> [[gnu::always_inline]] inline V force(V extension, V modulus) const { return modulus * extension; }
  /// Work done on the way to an extension: the integral of `force`.
  double energy(double extension, double modulus) const { return modulus * extension * extension / 2; }
  /// Whether a broken bond resists at an extension, with the force and energy of a whole one; else it has neither. Both
  /// are continuous where it begins, so that the energy of a cracked sample is convex and has one equilibrium.
  static bool resists_broken(double extension) { return extension < 0; }
  /// How near a bond is to breaking, 1 where it breaks. Stretch only breaks it.
  double damage(double stretch, double critical) const { return stretch / critical; }
  /// The stretch at which a bond breaks, so that a crack takes the energy G = K^2/E: sqrt(4 pi G/(9 E h)), h = 3 dx,
  /// plane stress.
  double critical_stretch(double k, double e, double dx) const {
    return k / e * std::sqrt(4 * std::numbers::pi / (9 * horizon * dx));
  }
  /// The same of a flat crack through a lattice in space, in plane strain: G = K^2 (1 - nu^2)/E is what its bonds hold
  /// when they break, s^2 E dx times `across`, the energy at unit stretch of all that cross a plane along the lattice,
  /// of unit modulus, spacing and area.
  double critical_stretch_in_space(double k, double e, double dx, double across) const {
    return k / e * std::sqrt((1 - space_lattice_poisson * space_lattice_poisson) / (across * dx));
  }
};

}  // namespace arenite::peridynamics
