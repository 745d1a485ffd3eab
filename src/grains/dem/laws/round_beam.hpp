#pragma once
#include <type_traits>

#include "core/vec.hpp"
#include "grains/dem/laws/beam.hpp"

namespace arenite::dem {

// Bonds of spheres are cylinders: beside their tension they have a shear and a bending of two components each, as
// vectors across the line between the grains, and they twist about it.

struct RoundBeam : Beam {
  double twist = 0;      ///< stiffness against twisting, N m/rad
  double per_twist = 0;  ///< radius over the polar moment of the section, 1/m^3
};
struct RoundStrain {
  double stretch = 0;       ///< m
  Vec3 shear{}, bending{};  ///< m, about the axes of these vectors; rad
  double twist = 0;         ///< of i against j, rad
};
struct RoundForce {
  double tension = 0;      ///< N
  Vec3 shear{}, moment{};  ///< N, N m
  double twist = 0;        ///< N m
};
inline RoundForce operator+(const RoundForce& a, const RoundForce& b) {
  return {a.tension + b.tension, a.shear + b.shear, a.moment + b.moment, a.twist + b.twist};
}
struct RoundDashpots : BeamDashpots<double> {
  double twist = 0;  ///< N m s
  RoundForce force(const RoundStrain& rate) const {
    return {normal * rate.stretch, shear * rate.shear, bending * rate.bending, twist * rate.twist};
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
