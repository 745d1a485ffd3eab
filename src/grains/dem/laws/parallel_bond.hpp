#pragma once
#include <cmath>
#include <numbers>

#include "grains/dem/laws/parts.hpp"
#include "model/links.hpp"

namespace arenite::dem {

/// What a bond's forces and stresses follow from: its stiffness against its three strains, 1 over its section and section modulus, and what pressure
/// adds to its shear strength. The loop over bonds keeps such numbers in one array each.
template <class Number> struct BeamOf {
  Number normal{}, shear{}, bending{};  ///< N/m, N/m, N m/rad
  Number per_area{}, per_section{};     ///< 1/m^2, 1/m^3
  Number friction{};                    ///< tan(phi)
};
using Beam = BeamOf<double>;

/// How a bond is strained: longer than it was made, the ways of both grains' surfaces across it, and the turn of i against j.
struct BeamStrain {
  double stretch = 0, shear = 0, bending = 0;  ///< m, m, rad
};

/// What it answers with: tension (> 0 pulls), shear force and bending moment.
struct BeamForce {
  double tension = 0, shear = 0, moment = 0;  ///< N, N, N m
};

/// The greatest stress over the strength for it, and which that is.
struct BeamLoad {
  double share = 0;
  BondBreak kind = BondBreak::none;
};

/// Grains without cement.
struct NoBonds : WithoutParameters {
  static constexpr Word word{"none", "no cement between grains"};

  double gap = 0, damping = 0, scatter = 0, tensile_strength = 0, cohesion = 0;
  std::int64_t seed = 0;
  Beam beam(double /*length*/, double /*radius*/, double /*thickness*/) const { return {}; }
  BeamForce elastic(const Beam&, const BeamStrain&) const { return {}; }
  double energy(const Beam&, const BeamStrain&) const { return 0; }
  BeamLoad load(const Beam&, const BeamForce&) const { return {}; }
};

/// Parallel bond (Potyondy and Cundall, Int. J. Rock Mech. 41, 1329, 2004) of half width R = share times the smaller radius: A = 2 R t, I = 2 R^3 t/3,
/// k_n = E A/l, k_s = k_n over the stiffness ratio, k_b = E I/l. It breaks where T/A + |M| R/I reaches the tensile strength or |Q|/A the cohesion,
/// raised by tan(phi) times the pressure on its section. Between two grains it acts beside their contact.
struct ParallelBond {
  static constexpr Word word{"parallel", "beams that take tension, shear and bending and break for good"};
  void declare(ParameterVisitor& v) {
    v.number({"bond_modulus", "Young's modulus E of the bonds.", true}, modulus, "GPa", range::positive);
    v.number({"bond_stiffness_ratio", "Normal over shear stiffness of the bonds."}, stiffness_ratio, "", range::positive);
    v.number({"bond_width", "Half width of a bond over the smaller of its two radii."}, width, "", range::above(0, 1));
    v.number({"bond_tensile_strength", "Tensile strength of the bonds, reached in their outermost fibre.", true}, tensile_strength, "MPa", range::positive);
    v.number({"bond_cohesion", "Shear strength of the bonds at zero normal stress.", true}, cohesion, "MPa", range::positive);
    v.number({"bond_friction_angle", "Friction angle by which pressure on a bond raises its shear strength."}, friction_angle, "deg",
             range::between(0, 80 * std::numbers::pi / 180));
    v.number({"bond_strength_scatter", "Standard deviation of the bonds' strengths, normally distributed, over their mean; none is below a tenth of it."},
             scatter, "", range::between(0, 0.5));
    v.integer({"bond_seed", "Seed of that scatter."}, seed, {0, 1'000'000'000});
    v.number({"bond_damping", "Damping of the bonds, as a fraction of critical damping."}, damping, "", range::between(0, 1));
    v.number({"bond_gap", "Largest gap between two bonded grains, over the mean radius."}, gap, "", range::between(0, 0.1));
  }
  bool operator==(const ParallelBond&) const = default;

  double modulus = 1e9, stiffness_ratio = 2.5, width = 1;
  double tensile_strength = 1e7, cohesion = 1e7, friction_angle = 0;  ///< Pa, Pa, rad
  double scatter = 0, damping = 0, gap = 0;
  std::int64_t seed = 1;

  Beam beam(double length, double radius, double thickness) const {
    const double half = width * radius, area = 2 * half * thickness, normal = modulus * area / length;
    return {normal, normal / stiffness_ratio, normal * half * half / 3, 1 / area, 3 / (area * half), std::tan(friction_angle)};
  }
  BeamForce elastic(const Beam& beam, const BeamStrain& strain) const {
    return {beam.normal * strain.stretch, beam.shear * strain.shear, beam.bending * strain.bending};
  }
  double energy(const Beam& beam, const BeamStrain& s) const {
    return 0.5 * (beam.normal * s.stretch * s.stretch + beam.shear * s.shear * s.shear + beam.bending * s.bending * s.bending);
  }
  BeamLoad load(const Beam& beam, const BeamForce& force) const {
    const double mean = force.tension * beam.per_area, bent = std::abs(force.moment) * beam.per_section;
    const BeamLoad pull{(mean + bent) / tensile_strength, mean > bent ? BondBreak::tension : BondBreak::bending};
    const BeamLoad across{std::abs(force.shear) * beam.per_area / (cohesion + beam.friction * lane::max(-mean, 0.0)), BondBreak::shear};
    return pull.share >= across.share ? pull : across;
  }
};

}  // namespace arenite::dem
