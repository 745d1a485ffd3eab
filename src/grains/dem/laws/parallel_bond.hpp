#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "grains/dem/laws/beam.hpp"
#include "grains/dem/laws/round_beam.hpp"

namespace arenite::dem {

/// Grains without cement.
struct NoBonds : NoLaw {
  static constexpr Word word{"none", "no cement between grains"};

  double gap = 0, damping = 0, scatter = 0;
  std::int64_t seed = 0;
  Beam beam(double /*length*/, double /*radius*/, double /*thickness*/) const { return {}; }
  RoundBeam round_beam(double /*length*/, double /*radius*/) const { return {}; }
  template <class V> BeamForce<V> elastic(const BeamOf<V>&, const BeamStrain<V>&) const { return {}; }
  template <class V> RoundForceOf<V> elastic(const RoundBeamOf<V>&, const RoundStrainOf<V>&) const { return {}; }
  double energy(const Beam&, const BeamStrain<double>&) const { return 0; }
  double energy(const RoundBeam&, const RoundStrain&) const { return 0; }
  template <class B, class F, class V> auto holds(const B& /*beam*/, const F& /*force*/, V strength) const {
    return strength <= strength;
  }
  BeamLoad load(const Beam&, const BeamForce<double>&) const { return {}; }
  BeamLoad load(const RoundBeam&, const RoundForce&) const { return {}; }
};

/// Parallel bond (Potyondy and Cundall, Int. J. Rock Mech. 41, 1329, 2004) of half width R = share times the smaller
/// radius: A = 2 R t, I = 2 R^3 t/3, k_n = E A/l, k_s = k_n over the stiffness ratio, k_b = E I/l. It breaks where T/A
/// + |M| R/I reaches the tensile strength or |Q|/A the cohesion, raised by tan(phi) times the pressure on its section.
/// Between two grains it acts beside their contact. Of spheres it is a cylinder of radius R: A = pi R^2, I = pi R^4/4,
/// J = 2 I, and k_t = k_s J/A against twisting, whose shear M_t R/J on the rim is added to that of Q.
struct ParallelBond {
  static constexpr Word word{"parallel", "beams that take tension, shear and bending and break for good"};
  void declare(ParameterVisitor& v) {
    v.number({"bond_modulus", "Young's modulus E of the bonds.", true}, modulus, "GPa", range::positive);
    v.number({"bond_stiffness_ratio", "Normal over shear stiffness of the bonds."}, stiffness_ratio, "",
             range::positive);
    v.number({"bond_width", "Half width of a bond over the smaller of its two radii."}, width, "", range::above(0, 1));
    v.number({"bond_tensile_strength", "Tensile strength of the bonds, reached in their outermost fibre.", true},
             tensile_strength, "MPa", range::positive);
    v.number({"bond_cohesion", "Shear strength of the bonds at zero normal stress.", true}, cohesion, "MPa",
             range::positive);
    v.number({"bond_friction_angle", "Friction angle by which pressure on a bond raises its shear strength."},
             friction_angle, "deg", range::between(0, 80 * std::numbers::pi / 180));
    v.number({"bond_strength_scatter",
              "Standard deviation of the bonds' strengths, normally distributed, over their mean; none is below a "
              "tenth of it."},
             scatter, "", range::between(0, 0.5));
    v.integer({"bond_seed", "Seed of that scatter."}, seed, {0, 1'000'000'000});
    v.number({"bond_damping", "Damping of the bonds, as a fraction of critical damping."}, damping, "",
             range::between(0, 1));
    v.number({"bond_gap", "Largest gap between two bonded grains, over the mean radius."}, gap, "",
             range::between(0, 0.1));
  }
  bool operator==(const ParallelBond&) const = default;

  double modulus = 1e9, stiffness_ratio = 2.5, width = 1;
  double tensile_strength = 1e7, cohesion = 1e7, friction_angle = 0;  ///< Pa, Pa, rad
  double scatter = 0, damping = 0, gap = 0;
  std::int64_t seed = 1;

  Beam beam(double length, double radius, double thickness) const {
    const double half = width * radius, area = 2 * half * thickness, normal = modulus * area / length;
    return {normal,   normal / stiffness_ratio, normal * half * half / 3,
            1 / area, 3 / (area * half),        std::tan(friction_angle)};
  }
  RoundBeam round_beam(double length, double radius) const {
    const double r = width * radius, area = std::numbers::pi * r * r, normal = modulus * area / length,
                 shear = normal / stiffness_ratio;
    RoundBeam beam;
    static_cast<Beam&>(beam) = {normal, shear, normal * r * r / 4, 1 / area, 4 / (area * r), std::tan(friction_angle)};
    beam.twist = shear * r * r / 2;
    beam.per_twist = 2 / (area * r);
    return beam;
  }
  template <class V> BeamForce<V> elastic(const BeamOf<V>& beam, const BeamStrain<V>& strain) const {
    return {beam.normal * strain.stretch, beam.shear * strain.shear, beam.bending * strain.bending};
  }
  template <class V> RoundForceOf<V> elastic(const RoundBeamOf<V>& beam, const RoundStrainOf<V>& strain) const {
    return {beam.normal * strain.stretch, beam.shear * strain.shear, beam.bending * strain.bending,
            beam.twist * strain.twist};
  }
  double energy(const Beam& beam, const BeamStrain<double>& s) const {
    return 0.5 * (beam.normal * s.stretch * s.stretch + beam.shear * s.shear * s.shear +
                  beam.bending * s.bending * s.bending);
  }
  double energy(const RoundBeam& beam, const RoundStrain& s) const { return 0.5 * power_of(elastic(beam, s), s); }
  template <class B, class F, class V> auto holds(const B& beam, const F& force, V strength) const {
    const Stresses<V> is = stresses(beam, force);
    const auto in_tension = is.mean + is.bent <= strength * V(tensile_strength),
               in_shear = is.across <= strength * shear_strength(beam, is);
    return in_tension & in_shear;
  }
  BeamLoad load(const Beam& beam, const BeamForce<double>& force) const {
    return load(beam, stresses(beam, force), BondBreak::shear);
  }
  BeamLoad load(const RoundBeam& beam, const RoundForce& force) const {
    const double twisted = std::abs(force.twist) * beam.per_twist;
    const Stresses<double> is = stresses(beam, force);
    return load(beam, is, is.across > 2 * twisted ? BondBreak::shear : BondBreak::twisting);
  }

 private:
  /// T/A, |M| R/I and |Q|/A, of cylinders with what twisting adds, Pa.
  template <class V> struct Stresses { V mean, bent, across; };
  BeamLoad load(const Beam& beam, const Stresses<double>& is, BondBreak by_shear) const {
    const BeamLoad pull{(is.mean + is.bent) / tensile_strength,
                        is.mean > is.bent ? BondBreak::tension : BondBreak::bending};
    const BeamLoad across{is.across / shear_strength(beam, is), by_shear};
    return pull.share >= across.share ? pull : across;
  }
  template <class V> static Stresses<V> stresses(const BeamOf<V>& beam, const BeamForce<V>& force) {
    using lane::abs;
    return {force.tension * beam.per_area, abs(force.moment) * beam.per_section, abs(force.shear) * beam.per_area};
  }
  template <class V> static Stresses<V> stresses(const RoundBeamOf<V>& beam, const RoundForceOf<V>& force) {
    using lane::abs;
    return {force.tension * beam.per_area, norm(force.moment) * beam.per_section,
            norm(force.shear) * beam.per_area + abs(force.twist) * beam.per_twist};
  }
  template <class V> V shear_strength(const BeamOf<V>& beam, const Stresses<V>& is) const {
    using lane::max;
    return V(cohesion) + beam.friction * max(V(0.0) - is.mean, V(0.0));
  }
};

}  // namespace arenite::dem
