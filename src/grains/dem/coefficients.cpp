#include "grains/dem/coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/root.hpp"

namespace arenite::dem {
namespace {

/// ln e of a collision that ends where spring and dashpot cancel, since the dashpot cannot pull; zeta = alpha_n/(2
/// sqrt(m_eff k)).
long double log_clipped_restitution(long double zeta) {
  if (zeta == 1) return -2;
  const long double s = std::sqrt(std::abs(1 - zeta * zeta));
  const long double time = zeta < 1 ? std::atan2(2 * zeta * s, 2 * zeta * zeta - 1) : std::log((zeta + s) / (zeta - s));
  return -zeta / s * time;
}

/// Found with more digits than a double has, so that rounding in the law above does not show.
double clipped_damping_ratio(double restitution) {
  const long double wanted = std::log(static_cast<long double>(restitution)),
                    most = 1 / std::sqrt(static_cast<long double>(restitution));
  const auto excess = [&](long double zeta) { return log_clipped_restitution(zeta) - wanted; };
  return static_cast<double>(2 * bracketed_root<long double>(excess, 0, -wanted, most, excess(most)));
}

/// Series rule: two springs of 2k each, one after the other, so that like grains keep k.
double in_series(double a, double b) { return 1.0 / (1.0 / (2.0 * a) + 1.0 / (2.0 * b)); }

/// What one side of a contact yields under pressure and under shear, 1/Pa: 1/E* and 1/G* are the sums of both sides.
struct Yielding {
  double normal = 0, shear = 0;
};
Yielding operator+(Yielding a, Yielding b) { return {a.normal + b.normal, a.shear + b.shear}; }
Yielding yielding_of(const Material& m) {
  const double e = m.youngs_modulus.value_or(0), nu = m.poisson.value_or(0);
  return {(1 - nu * nu) / e, 2 * (2 - nu) * (1 + nu) / e};
}

double stiffness_of_pair(StiffnessRule rule, double a, double b, bool alike) {
  if (rule == StiffnessRule::series) return in_series(a, b);
  return alike ? a : a * b / (a + b);
}

double stiffness_of_wall(WallStiffness rule, double grain, double stiffest) {
  if (rule == WallStiffness::series) return in_series(grain, stiffest);
  return rule == WallStiffness::grain ? grain : stiffest;
}

}  // namespace

double damping_ratio(double restitution, bool may_pull) {
  if (!may_pull) return clipped_damping_ratio(restitution);
  const double l = std::log(restitution);
  return -2.0 * l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l);
}

CoefficientTable::CoefficientTable(const Materials& materials, const std::vector<std::int32_t>& used,
                                   const ContactParameters& contact)
    : damping_ratio_(damping_ratio(contact.restitution, contact.attractive_dashpot)),
      of_moduli_(contact.takes_moduli()),
      contact_(contact) {
  const auto spring_of = [](Yielding y) { return Spring{4.0 / 3.0 / y.normal, 4.0 * y.normal / y.shear}; };
  double stiffest = 0;
  for (const int m : used) stiffest = std::max(stiffest, materials[m].stiffness);
  for (const Material& a : materials) {
    for (const Material& b : materials)
      pair_.push_back(of_moduli_
                          ? spring_of(yielding_of(a) + yielding_of(b))
                          : Spring{stiffness_of_pair(contact.stiffness_rule, a.stiffness, b.stiffness, &a == &b)});
    wall_.push_back(of_moduli_ ? spring_of(yielding_of(a))
                               : Spring{stiffness_of_wall(contact.wall_stiffness, a.stiffness, stiffest)});
  }
}

double CoefficientTable::largest_shear() const {
  return std::ranges::max(wall_, {}, &Spring::shear).shear;  // that of a pair lies between those of its sides
}

Coefficients CoefficientTable::with_dashpots(double stiffness, double shear, double reduced_mass) const {
  const double damping = contact_.normal_damping.value_or(damping_ratio_ * std::sqrt(reduced_mass * stiffness));
  return {stiffness, damping, contact_.sliding_viscosity.value_or(damping), 0, shear};
}

}  // namespace arenite::dem
