#pragma once
#include "grains/dem/laws/hertz.hpp"

namespace arenite::dem {

/// Hertz contact of elastic spheres, F = (4/3) E* sqrt(R*) h^(3/2) with 1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j; a
/// wall is a rigid plane. It is Hertz's law with k = (4/3) E* R*, of each pair, its dashpot included. The spring of
/// friction is that of Mindlin without slip, k_t = 8 G* sqrt(R* h), 1/G* = 2 (2 - nu_i) (1 + nu_i)/E_i + the same of j.
/// With the slip xi since the contact began F_t = -k_t(h) xi: xi is not rescaled where h falls (gran/hertz/history of
/// LAMMPS). A spring that is loaded at small h and relaxed at large h therefore gives back more than it took (Elata and
/// Berryman, Mechanics of Materials 24, 229, 1996).
struct HertzMindlin : Hertz {
  static constexpr Word word{"hertz_mindlin",
                             "Hertz contact of spheres with E and nu, with Mindlin's tangential spring"};

  /// What the spring of friction is a share of, N/m: the tangent stiffness S = 2 E* sqrt(R* h), so that k_t/S = 4
  /// G*/E*.
  template <class V> V sliding_base(V h, V stiffness, V curvature) const {
    using lane::sqrt;
    return V(1.5) * stiffness * sqrt(h * curvature);
  }
};

}  // namespace arenite::dem
