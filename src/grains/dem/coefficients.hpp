#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "grains/dem/parameters.hpp"
#include "model/packing.hpp"

namespace arenite::dem {

/// What a contact law needs to know of one pair beside its motion.
struct Coefficients {
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< alpha_n, N s/m
  double viscosity = 0;  ///< gamma_s, N s/m
  double strength = 0;   ///< gamma sqrt(r_eff) if the pair is glued, else 0
};

/// Coefficients of a pair from the materials, masses and radii of its grains.
class CoefficientTable {
 public:
  CoefficientTable() = default;
  CoefficientTable(const Materials& materials, const Grains& grains, const ContactParameters& contact);

  /// Two grains, by material, mass (kg) and radius.
  Coefficients pair(int material_i, int material_j, double mass_i, double mass_j, double radius_i, double radius_j, bool glued) const;
  /// A grain and a wall, m_eff = m.
  Coefficients wall(int material, double mass) const;

  double pair_stiffness(int material_i, int material_j) const { return pair_[index(material_i, material_j)]; }
  double wall_stiffness(int material) const { return wall_[static_cast<std::size_t>(material)]; }

 private:
  std::size_t index(int a, int b) const { return static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b); }
  double damping(double stiffness, double reduced_mass) const;

  std::size_t count_ = 0;
  std::vector<double> pair_, wall_;
  double damping_ratio_ = 0;  ///< 2 beta of alpha_n = 2 beta sqrt(m_eff k)
  ContactParameters contact_;
};

/// alpha_n/sqrt(m_eff k), so that a binary collision has restitution e: -2 ln e/sqrt(pi^2 + ln^2 e) where the dashpot may pull; where it may not, the
/// collision ends sooner and takes the root of Schwager and Poeschel's closed form (Granular Matter 9, 465, 2007). e = 0 is not reached by any finite
/// damping.
double damping_ratio(double restitution, bool may_pull);

}  // namespace arenite::dem
