#include "geometry/liquid_bridge.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "core/root.hpp"

namespace arenite::geometry {
namespace {

using std::numbers::pi;

/// One disk as seen from its centre: the direction to the arc's centre at (along, y), turned back to the point where
/// the arc ends. Primes are derivatives by the arc's radius.
struct Wetting {
  double filling = 0, slope = 0;  ///< angle from the joining line to the end of the arc, rad; its derivative, rad/m
};
Wetting wetting(double radius, double contact_angle, double arc, double along, double y, double along_prime,
                double y_prime) {
  const double c = std::cos(contact_angle), s = std::sin(contact_angle);
  const double squared = along * along + y * y;  // r^2 + R^2 + 2 r R cos(theta)
  return {std::atan2(y, along) - std::atan2(arc * s, radius + arc * c),
          (y_prime * along - y * along_prime - radius * s) / squared};
}

/// Where a function that grows with its argument is 0; `low` is below it.
double root_above(const std::function<double(double)>& f, double low, double first_step) {
  const double at_low = f(low);
  if (at_low >= 0) return low;
  double high = low + first_step;
  while (f(high) < 0) high = low + 2 * (high - low);
  return bracketed_root<double>(f, low, at_low, high, f(high));
}

}  // namespace

BridgeState bridge_state(const LiquidBridge& b, double gap, double arc) {
  const double ri = b.radius_i, rj = b.radius_j, c = std::cos(b.contact_angle), s = std::sin(b.contact_angle);
  const double distance = ri + rj + gap;
  // Centre of the arc, (x, y) from centre i.
  const double x = (distance * distance + ri * ri - rj * rj + 2 * arc * c * (ri - rj)) / (2 * distance);
  const double y = std::sqrt(std::fmax(ri * ri + arc * arc + 2 * ri * arc * c - x * x, 0.0));
  const double x_prime = c * (ri - rj) / distance, y_prime = (arc + ri * c - x * x_prime) / y;
  const Wetting i = wetting(ri, b.contact_angle, arc, x, y, x_prime, y_prime);
  const Wetting j = wetting(rj, b.contact_angle, arc, distance - x, y, -x_prime, y_prime);
  const double turn = pi - i.filling - j.filling - 2 * b.contact_angle;  // of the arc
  BridgeState state;
  state.area = distance * y - arc * s * (ri + rj) - ri * ri * i.filling - rj * rj * j.filling - arc * arc * turn;
  state.neck = y - arc;
  state.energy = 2 * arc * turn - 2 * c * (ri * i.filling + rj * j.filling);
  state.pull = 2 * y / arc;
  // At constant radius of the arc d area/d gap = 2 (y - R y'), for the surfaces' energy and the liquid's have one
  // potential.
  const double area_prime = distance * y_prime - s * (ri + rj) - ri * ri * i.slope - rj * rj * j.slope -
                            2 * arc * turn + arc * arc * (i.slope + j.slope);
  const double area_by_gap = 2 * (y - arc * y_prime), pull_prime = 2 * (y_prime - y / arc) / arc;
  state.slope = -2 / arc * x * (1 - x / distance) / y - pull_prime * area_by_gap / area_prime;
  return state;
}

double thinnest_arc(const LiquidBridge& b, double gap) {
  // The neck is 0 where the arc's centre lies at y = R: x^2 = r_i^2 + 2 r_i R cos(theta), and x is linear in R.
  const double ri = b.radius_i, rj = b.radius_j, c = std::cos(b.contact_angle), distance = ri + rj + gap;
  const double beyond = gap * (distance - ri + rj) / (2 * distance);  // x - r_i at R = 0
  const double m = c * (ri - rj) / distance;
  const double half = ri * c - (ri + beyond) * m, rest = beyond * (2 * ri + beyond);
  return rest / (half + std::sqrt(std::fmax(half * half - m * m * rest, 0.0)));
}

double arc_radius(const LiquidBridge& b, double gap, double area) {
  const auto excess = [&](double arc) { return arc > 0 ? bridge_state(b, gap, arc).area - area : -area; };
  const double low = gap > 0 ? thinnest_arc(b, gap) : 0;
  return root_above(excess, low, low > 0 ? low : 1e-3 * std::fmin(b.radius_i, b.radius_j));
}

double rupture_gap(const LiquidBridge& b, double area) {
  const auto excess = [&](double gap) {
    return gap > 0 ? bridge_state(b, gap, thinnest_arc(b, gap)).area - area : -area;
  };
  return root_above(excess, 0, std::sqrt(area));
}

double straight_bridge_area(const LiquidBridge& b) {
  return bridge_state(b, 0, 1e3 * std::fmax(b.radius_i, b.radius_j)).area;
}

}  // namespace arenite::geometry
