#pragma once
#include "grains/dem/laws/parts.hpp"
#include "model/links.hpp"

namespace arenite::dem {

// Bonds are beams between two grains: how one is strained by their motion, and what its forces do to them. Like the
// laws this is written once over a number type. An array of each of these numbers is one, too, so that the loop over
// bonds has its columns by the same names.

/// What a bond's forces and stresses follow from: its stiffness against its three strains, 1 over its section and
/// section modulus, and what pressure adds to its shear strength.
template <class V> struct BeamOf {
  V normal{}, shear{}, bending{};  ///< N/m, N/m, N m/rad
  V per_area{}, per_section{};     ///< 1/m^2, 1/m^3
  V friction{};                    ///< tan(phi)
};
using Beam = BeamOf<double>;

/// How a bond is strained: longer than it was made, the ways of both grains' surfaces across it, and the turn of i
/// against j.
template <class V> struct BeamStrain {
  V stretch{}, shear{}, bending{};  ///< m, m, rad
};

/// What it answers with: tension (> 0 pulls), shear force and bending moment.
template <class V> struct BeamForce {
  V tension{}, shear{}, moment{};  ///< N, N, N m
};
template <class V> BeamForce<V> operator+(const BeamForce<V>& a, const BeamForce<V>& b) {
  return {a.tension + b.tension, a.shear + b.shear, a.moment + b.moment};
}

/// The greatest stress over the strength for it, and which that is.
struct BeamLoad {
  double share = 0;
  BondBreak kind = BondBreak::none;
};

/// Dashpots beside a bond, against the rates of its three strains: N s/m, N s/m, N m s.
template <class V> struct BeamDashpots {
  V normal{}, shear{}, bending{};
  BeamForce<V> force(const BeamStrain<V>& rate) const {
    return {normal * rate.stretch, shear * rate.shear, bending * rate.bending};
  }
};

/// Force on i, N, and torques on both grains, N m.
template <class V> struct BeamPull {
  Vec<2, V> on_i;
  V torque_i, torque_j;
};

/// A bond's length when it was made, and the arms of its grains to its middle between the two surfaces, m.
template <class V> struct BeamArms {
  V length{}, arm_i{}, arm_j{};

  /// Of grains that are turned so against the line from j to i.
  BeamStrain<V> strain(V distance, V turn_i, V turn_j) const {
    return {distance - length, arm_i * turn_i + arm_j * turn_j, turn_i - turn_j};
  }
  /// The rate of it where that line lengthens and turns so.
  BeamStrain<V> rate(V lengthening, V turning, V turning_i, V turning_j) const {
    return {lengthening, arm_i * turning_i + arm_j * turning_j - length * turning, turning_i - turning_j};
  }
  /// On grains in the direction `n` from j to i; `across` is the shear force on them, on whose lever, their distance,
  /// it has the moment that it has on the beam's length.
  BeamPull<V> pull(const BeamForce<V>& f, Vec<2, V> n, V across) const {
    const V none(0.0);
    return {{none - f.tension * n.x - across * n.y, across * n.x - f.tension * n.y},
            none - f.shear * arm_i - f.moment,
            f.moment - f.shear * arm_j};
  }
};

}  // namespace arenite::dem
