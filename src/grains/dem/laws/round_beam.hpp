#pragma once
#include <type_traits>

#include "core/vec.hpp"
#include "geometry/rotation.hpp"
#include "grains/dem/laws/beam.hpp"

namespace arenite::dem {

// Bonds of spheres are cylinders: beside their tension they have a shear and a bending of two components each, as
// vectors across the line between the grains, and they twist about it.

template <class V> struct RoundBeamOf : BeamOf<V> {
  V twist{};      ///< stiffness against twisting, N m/rad
  V per_twist{};  ///< radius over the polar moment of the section, 1/m^3
};
using RoundBeam = RoundBeamOf<double>;
template <class V> struct RoundStrainOf {
  V stretch{};                   ///< m
  Vec<3, V> shear{}, bending{};  ///< m, about the axes of these vectors; rad
  V twist{};                     ///< of i against j, rad
};
using RoundStrain = RoundStrainOf<double>;
template <class V> struct RoundForceOf {
  V tension{};                  ///< N
  Vec<3, V> shear{}, moment{};  ///< N, N m
  V twist{};                    ///< N m
};
using RoundForce = RoundForceOf<double>;
template <class V> RoundForceOf<V> operator+(const RoundForceOf<V>& a, const RoundForceOf<V>& b) {
  return {a.tension + b.tension, a.shear + b.shear, a.moment + b.moment, a.twist + b.twist};
}
template <class V> struct RoundDashpotsOf : BeamDashpots<V> {
  V twist{};  ///< N m s
  RoundForceOf<V> force(const RoundStrainOf<V>& rate) const {
    return {this->normal * rate.stretch, this->shear * rate.shear, this->bending * rate.bending, twist * rate.twist};
  }
};
using RoundDashpots = RoundDashpotsOf<double>;

/// The grains at the ends of a cylinder: where the line from j to i, as it was made, has turned with each, and how i
/// has turned past j, by less than half a turn.
template <class V> struct RoundEnds {
  Vec<3, V> along_i, along_j;
  geometry::RotationOf<V> between;
};

/// Force on i, N, and torques on both grains, N m.
template <class V> struct RoundPull { Vec<3, V> on_i, torque_i, torque_j; };

/// Length and arms as of beams of the plane. `n` is the line from j to i as it is now.
template <class V> struct RoundArms : BeamArms<V> {
  /// Of grains that are twisted so about the line. Bending is counted by the sines of its angles.
  RoundStrainOf<V> strain(V distance, Vec<3, V> n, const RoundEnds<V>& ends, V twist) const {
    const Vec<3, V> bent_i = cross(n, ends.along_i), bent_j = cross(n, ends.along_j);
    return {distance - this->length, this->arm_i * bent_i + this->arm_j * bent_j, bent_i - bent_j, twist};
  }
  /// The rate of it where i moves past j so and both turn; `inverse` is 1 over the distance.
  RoundStrainOf<V> rate(Vec<3, V> n, V inverse, Vec<3, V> velocity, Vec<3, V> turning_i, Vec<3, V> turning_j) const {
    const Vec<3, V> line = inverse * cross(n, velocity), against = turning_i - turning_j;
    return {dot(velocity, n), without_twist(this->arm_i * turning_i + this->arm_j * turning_j - this->length * line, n),
            without_twist(against, n), dot(against, n)};
  }
  /// The gradient of the energy. How the twist grows as i turns, as j turns the other way, and as the line does,
  /// follows from how i has turned past j.
  RoundPull<V> pull(const RoundForceOf<V>& f, Vec<3, V> n, V inverse, const RoundEnds<V>& ends) const {
    const Vec<3, V> on_bent_i = this->arm_i * f.shear + f.moment, on_bent_j = this->arm_j * f.shear - f.moment;
    const Vec<3, V> v = ends.between.sine;
    const V w = ends.between.cosine, p = dot(v, n), square = w * w, twist = f.twist / (square + p * p);
    const Vec<3, V> middle = square * n + p * v, aside = w * cross(v, n);
    const Vec<3, V> by_normal =
        cross(ends.along_i, on_bent_i) + cross(ends.along_j, on_bent_j) + V(2.0) * twist * w * v;
    return {-f.tension * n - inverse * without_twist(by_normal, n),
            -cross(ends.along_i, cross(on_bent_i, n)) - twist * (middle + aside),
            twist * (middle - aside) - cross(ends.along_j, cross(on_bent_j, n))};
  }
};

/// Of a bond in the plane or in space.
template <int D> using BeamIn = std::conditional_t<D == 2, Beam, RoundBeam>;
template <int D> using BeamStrainIn = std::conditional_t<D == 2, BeamStrain<double>, RoundStrain>;
template <int D> using BeamForceIn = std::conditional_t<D == 2, BeamForce<double>, RoundForce>;
template <int D> using BeamDashpotsIn = std::conditional_t<D == 2, BeamDashpots<double>, RoundDashpots>;

/// Stiffness and dashpot against twisting, which beams of the plane have none of.
inline double twist_stiffness(const Beam& /*beam*/) { return 0; }
inline double twist_stiffness(const RoundBeam& beam) { return beam.twist; }
inline double twist_damping(const BeamDashpots<double>& /*dashpots*/) { return 0; }
inline double twist_damping(const RoundDashpots& dashpots) { return dashpots.twist; }

/// What a beam's forces do where it is strained at this rate, W.
inline double power_of(const BeamForce<double>& f, const BeamStrain<double>& rate) {
  return f.tension * rate.stretch + f.shear * rate.shear + f.moment * rate.bending;
}
inline double power_of(const RoundForce& f, const RoundStrain& rate) {
  return f.tension * rate.stretch + dot(f.shear, rate.shear) + dot(f.moment, rate.bending) + f.twist * rate.twist;
}

}  // namespace arenite::dem
