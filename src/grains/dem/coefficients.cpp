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

/// What one side of a contact yields under pressure and under shear, 1/Pa: 1/E* and 1/G* are the sums of both sides.
struct Yielding {
  double normal = 0, shear = 0;
};

Yielding yielding_of(const Material& m) {
  const double e = m.youngs_modulus.value_or(0), nu = m.poisson.value_or(0);
  return {(1 - nu * nu) / e, 2 * (2 - nu) * (1 + nu) / e};
}

Yielding operator+(Yielding a, Yielding b) { return {a.normal + b.normal, a.shear + b.shear}; }
double spring_of(Yielding y) { return 4.0 / 3.0 / y.normal; }
double shear_of(Yielding y) { return 4.0 * y.normal / y.shear; }

}  // namespace

double damping_ratio(double restitution, bool may_pull) {
  if (!may_pull) return clipped_damping_ratio(restitution);
  const double l = std::log(restitution);
  return -2.0 * l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l);
}

CoefficientTable::CoefficientTable(const Materials& materials, const Grains& grains, const ContactParameters& contact)
    : count_(materials.size()),
      damping_ratio_(damping_ratio(contact.restitution, contact.attractive_dashpot)),
      of_moduli_(contact.takes_moduli()),
      contact_(contact) {
  if (of_moduli_) take_moduli(materials);
  else take_stiffnesses(materials, grains);
}

void CoefficientTable::take_stiffnesses(const Materials& materials, const Grains& grains) {
  double stiffest = 0;
  for (const int m : grains.material) stiffest = std::max(stiffest, materials[m].stiffness);
  for (std::size_t a = 0; a < count_; ++a) {
    const double ka = materials[a].stiffness;
    for (std::size_t b = 0; b < count_; ++b) {
      const double kb = materials[b].stiffness;
      const bool series = contact_.stiffness_rule == StiffnessRule::series;
      pair_.push_back(series ? in_series(ka, kb) : a == b ? ka : ka * kb / (ka + kb));
    }
    switch (contact_.wall_stiffness) {
      case WallStiffness::stiffest: wall_.push_back(stiffest); break;
      case WallStiffness::grain: wall_.push_back(ka); break;
      case WallStiffness::series: wall_.push_back(in_series(ka, stiffest)); break;
    }
  }
}

void CoefficientTable::take_moduli(const Materials& materials) {
  for (const Material& a : materials) {
    const Yielding of_grain = yielding_of(a);
    for (const Material& b : materials) {
      pair_.push_back(spring_of(of_grain + yielding_of(b)));
      pair_shear_.push_back(shear_of(of_grain + yielding_of(b)));
    }
    wall_.push_back(spring_of(of_grain));
    wall_shear_.push_back(shear_of(of_grain));
    largest_shear_ = std::max(largest_shear_, wall_shear_.back());  // that of a pair lies between those of its sides
  }
}

double CoefficientTable::damping(double stiffness, double reduced_mass) const {
  return contact_.normal_damping.value_or(damping_ratio_ * std::sqrt(reduced_mass * stiffness));
}

Coefficients CoefficientTable::pair(int material_i, int material_j, double mass_i, double mass_j, double radius_i, double radius_j, bool glued) const {
  Coefficients c;
  c.stiffness = pair_stiffness(material_i, material_j, radius_i, radius_j);
  if (of_moduli_) c.shear = pair_shear_[index(material_i, material_j)];
  c.damping = damping(c.stiffness, mass_i * mass_j / (mass_i + mass_j));
  c.viscosity = contact_.sliding_viscosity.value_or(c.damping);
  if (glued) c.strength = contact_.surface_energy * std::sqrt(elasticity::effective_radius(contact_.effective_radius, radius_i, radius_j));
  return c;
}

Coefficients CoefficientTable::wall(int material, double mass, double radius) const {
  Coefficients c;
  c.stiffness = wall_stiffness(material, radius);
  if (of_moduli_) c.shear = wall_shear_[material];
  c.damping = damping(c.stiffness, mass);
  c.viscosity = contact_.sliding_viscosity.value_or(c.damping);
  return c;
}

}  // namespace arenite::dem
