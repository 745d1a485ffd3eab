#include "grains/dem/coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/root.hpp"

namespace arenite::dem {
namespace {

/// ln e of a collision that ends where spring and dashpot cancel, since the dashpot cannot pull; zeta = alpha_n/(2 sqrt(m_eff k)).
long double log_clipped_restitution(long double zeta) {
  if (zeta == 1) return -2;
  const long double s = std::sqrt(std::abs(1 - zeta * zeta));
  const long double time = zeta < 1 ? std::atan2(2 * zeta * s, 2 * zeta * zeta - 1) : std::log((zeta + s) / (zeta - s));
  return -zeta / s * time;
}

/// Found with more digits than a double has, so that rounding in the law above does not show.
double clipped_damping_ratio(double restitution) {
  const long double wanted = std::log(static_cast<long double>(restitution)), most = 1 / std::sqrt(static_cast<long double>(restitution));
  const auto excess = [&](long double zeta) { return log_clipped_restitution(zeta) - wanted; };
  return static_cast<double>(2 * bracketed_root<long double>(excess, 0, -wanted, most, excess(most)));
}

/// Series rule: two springs of 2k each, one after the other, so that like grains keep k.
double in_series(double a, double b) { return 1.0 / (1.0 / (2.0 * a) + 1.0 / (2.0 * b)); }

}  // namespace

double damping_ratio(double restitution, bool may_pull) {
  if (!may_pull) return clipped_damping_ratio(restitution);
  const double l = std::log(restitution);
  return -2.0 * l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l);
}

CoefficientTable::CoefficientTable(const Materials& materials, const Grains& grains, const ContactParameters& contact)
    : count_(materials.size()),
      damping_ratio_(damping_ratio(contact.restitution, contact.attractive_dashpot)),
      contact_(contact) {
  double stiffest = 0;
  for (const int m : grains.material) stiffest = std::max(stiffest, materials[static_cast<std::size_t>(m)].stiffness);
  for (std::size_t a = 0; a < count_; ++a) {
    const double ka = materials[a].stiffness;
    for (std::size_t b = 0; b < count_; ++b) {
      const double kb = materials[b].stiffness;
      const bool series = contact.stiffness_rule == StiffnessRule::series;
      pair_.push_back(series ? in_series(ka, kb) : a == b ? ka : ka * kb / (ka + kb));
    }
    switch (contact.wall_stiffness) {
      case WallStiffness::stiffest: wall_.push_back(stiffest); break;
      case WallStiffness::grain: wall_.push_back(ka); break;
      case WallStiffness::series: wall_.push_back(in_series(ka, stiffest)); break;
    }
  }
}

double CoefficientTable::damping(double stiffness, double reduced_mass) const {
  return contact_.normal_damping.value_or(damping_ratio_ * std::sqrt(reduced_mass * stiffness));
}

Coefficients CoefficientTable::pair(int material_i, int material_j, double mass_i, double mass_j, double radius_i, double radius_j, bool glued) const {
  Coefficients c;
  c.stiffness = pair_[index(material_i, material_j)];
  c.damping = damping(c.stiffness, mass_i * mass_j / (mass_i + mass_j));
  c.viscosity = contact_.sliding_viscosity.value_or(c.damping);
  if (glued) c.strength = contact_.surface_energy * std::sqrt(elasticity::effective_radius(contact_.effective_radius, radius_i, radius_j));
  return c;
}

Coefficients CoefficientTable::wall(int material, double mass) const {
  Coefficients c;
  c.stiffness = wall_[static_cast<std::size_t>(material)];
  c.damping = damping(c.stiffness, mass);
  c.viscosity = contact_.sliding_viscosity.value_or(c.damping);
  return c;
}

}  // namespace arenite::dem
