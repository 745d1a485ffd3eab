#pragma once
#include <cmath>
#include <numbers>
#include <string_view>

#include "geometry/liquid_bridge.hpp"
#include "grains/dem/laws/parts.hpp"
#include "grains/dem/laws/pull_curve.hpp"

namespace arenite::dem {

/// What bridges of a liquid are given by. They are at rest at any gap (no viscosity), without weight, and all of one
/// volume, which a bridge keeps from the touch that makes it until it breaks.
struct Liquid {
  static constexpr bool breaks = true;
  static constexpr std::string_view reach_key = "liquid_volume";
  void declare(ParameterVisitor& v) {
    v.number({"surface_tension", "Surface tension of the liquid.", true}, surface_tension, "mN/m", range::positive);
    v.number({"contact_angle", "Angle at which the liquid meets a grain."}, contact_angle, "deg",
             range::between(0, 80 * std::numbers::pi / 180));
    v.number({"liquid_volume", "Volume of each bridge; of disks its area in the plane times the thickness.", true},
             volume, "mm^3", range::positive);
  }
  bool operator==(const Liquid&) const = default;

  double surface_tension = 0.0728, contact_angle = 0, volume = 1e-9;  ///< N/m, rad, m^3
  double joins_within() const { return 0; }
};

/// Liquid bridges between disks, exact: two circular arcs that meet both rims at the contact angle
/// (geometry/liquid_bridge.hpp; at contact angle 0 the menisci of the cement). The pull is the surfaces' tension and
/// Laplace's lower pressure in the liquid, the gradient of the surfaces' energy at constant volume; the bridge breaks
/// where the arcs meet in its middle.
struct CapillaryDisks : Liquid {
  static constexpr Word word{"capillary_disks", "liquid bridges between disks, exact in the plane"};
  bool operator==(const CapillaryDisks&) const = default;

  /// That two touching disks of this radius hold between straight surfaces.
  double largest_volume(double radius, double thickness) const {
    return thickness * geometry::straight_bridge_area({radius, radius, contact_angle});
  }
  PullCurve curve(double radius_i, double radius_j, double thickness) const {
    const geometry::LiquidBridge bridge{radius_i, radius_j, contact_angle};
    const double area = volume / thickness, reach = geometry::rupture_gap(bridge, area),
                 unit = surface_tension * thickness;
    const double free = geometry::bridge_state(bridge, 0, geometry::arc_radius(bridge, 0, area)).energy;
    return {reach, 0.25 * reach, [&](double gap) {
              const double arc =
                  gap < reach ? geometry::arc_radius(bridge, gap, area) : geometry::thinnest_arc(bridge, gap);
              const geometry::BridgeState state = geometry::bridge_state(bridge, gap, arc);
              return PullPoint{unit * (state.energy - free), unit * state.pull, unit * state.slope};
            }};
  }
};

/// Liquid bridges between spheres: F = 2 pi R gamma cos(theta)/(1 + 1.05 s + 2.5 s^2), s = gap sqrt(R/V), R = 2 r_i
/// r_j/(r_i + r_j) (Willett, Adams, Johnson and Seville, Langmuir 16, 9396, 2000), which break at the gap (1 + theta/2)
/// V^(1/3) (Lian, Thornton and Adams, J. Colloid Interface Sci. 161, 138, 1993).
struct CapillarySpheres : Liquid {
  static constexpr Word word{"capillary_spheres", "liquid bridges between spheres, fit of Willett et al."};
  bool operator==(const CapillarySpheres&) const = default;

  PullCurve curve(double radius_i, double radius_j, double /*thickness*/) const {
    const double radius = 2 * radius_i * radius_j / (radius_i + radius_j), per_gap = std::sqrt(radius / volume);
    const double most = 2 * std::numbers::pi * radius * surface_tension * std::cos(contact_angle);
    const double reach = (1 + 0.5 * contact_angle) * std::cbrt(volume);
    constexpr double a = 1.05, b = 2.5;
    const double root = std::sqrt(4 * b - a * a);
    return {reach, 1 / per_gap, [=](double gap) {
              const double s = gap * per_gap, below = 1 + a * s + b * s * s;
              const double turn = std::atan2(2 * b * s + a, root) - std::atan2(a, root);
              return PullPoint{most / per_gap * 2 / root * turn, most / below,
                               -most * per_gap * (a + 2 * b * s) / (below * below)};
            }};
  }
};

}  // namespace arenite::dem
