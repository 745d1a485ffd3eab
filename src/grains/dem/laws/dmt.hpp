#pragma once
#include <numbers>
#include <string_view>

#include "grains/dem/laws/parts.hpp"
#include "grains/dem/laws/pull_curve.hpp"

namespace arenite::dem {

/// Grains that neither stick nor are wet.
struct NoCohesion : NoLaw {
  static constexpr Word word{"none", "no cohesion"};
  static constexpr bool breaks = false;
  static constexpr std::string_view reach_key{};
  double joins_within() const { return 0; }
  PullCurve curve(double /*radius_i*/, double /*radius_j*/, double /*thickness*/) const { return {}; }
};

/// Adhesion of hard, dry grains (Derjaguin, Muller and Toporov, J. Colloid Interface Sci. 53, 314, 1975): whatever the
/// normal law, touching grains pull each other with the pull-off force of spheres, F_c = 2 pi w R, 1/R = 1/r_i + 1/r_j,
/// w the work of adhesion. Outside of the contact the pull falls linearly to 0 at the range d, which is what a constant
/// stress w/d between the surfaces up to that distance gives (Maugis, J. Colloid Interface Sci. 150, 243, 1992) and
/// what two-dimensional simulations of cohesive disks take (Gilabert, Roux and Castellanos, Phys. Rev. E 75, 011303,
/// 2007).
struct Dmt {
  static constexpr Word word{"dmt", "adhesion of dry grains, pull-off force 2 pi w R of spheres"};
  static constexpr bool breaks = false;
  static constexpr std::string_view reach_key = "adhesion_range";
  void declare(ParameterVisitor& v) {
    v.number({"work_of_adhesion", "Work of adhesion w of two grains, twice the surface energy of like ones.", true},
             work_of_adhesion, "J/m^2", range::positive);
    v.number({"adhesion_range",
              "Gap up to which two grains attract each other; the attraction falls linearly to zero there.", true},
             range_of_pull, "um", range::positive);
  }
  bool operator==(const Dmt&) const = default;

  double work_of_adhesion = 0.1, range_of_pull = 1e-6;  ///< J/m^2, m

  double joins_within() const { return range_of_pull; }
  double pull_off(double radius_i, double radius_j) const {
    return 2 * std::numbers::pi * work_of_adhesion * radius_i * radius_j / (radius_i + radius_j);
  }
  PullCurve curve(double radius_i, double radius_j, double /*thickness*/) const {
    const double most = pull_off(radius_i, radius_j), d = range_of_pull;
    return {d, d, [=](double gap) {
              const double left = 1 - gap / d;
              return PullPoint{-0.5 * most * d * left * left, most * left, -most / d};
            }};
  }
};

}  // namespace arenite::dem
