#pragma once
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
  double shear = 0;      ///< 4 G*/E* where the law is one of E and nu, else 0
};

/// Coefficients of a pair from the materials, masses and radii of its grains.
class CoefficientTable {
 public:
  CoefficientTable() = default;
  CoefficientTable(const Materials& materials, const Grains& grains, const ContactParameters& contact);

  /// Two grains, by material, mass (kg) and radius.
  Coefficients pair(int material_i, int material_j, double mass_i, double mass_j, double radius_i, double radius_j, bool glued) const;
  /// A grain and a wall, m_eff = m.
  Coefficients wall(int material, double mass, double radius) const;

  /// k; (4/3) E* R* where the law is one of E and nu, N/m.
  double pair_stiffness(int material_i, int material_j, double radius_i, double radius_j) const {
    return pair_[index(material_i, material_j)] * (of_moduli_ ? radius_i * radius_j / (radius_i + radius_j) : 1.0);
  }
  double wall_stiffness(int material, double radius) const { return wall_[material] * (of_moduli_ ? radius : 1.0); }
  /// The largest 4 G*/E* there is.
  double largest_shear() const { return largest_shear_; }

 private:
  std::size_t index(int a, int b) const { return static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b); }
  double damping(double stiffness, double reduced_mass) const;
  void take_stiffnesses(const Materials& materials, const Grains& grains);
  void take_moduli(const Materials& materials);

  std::size_t count_ = 0;
  std::vector<double> pair_, wall_;              ///< k, N/m; of moduli (4/3) E*, Pa
  std::vector<double> pair_shear_, wall_shear_;  ///< 4 G*/E*; empty unless of moduli
  double largest_shear_ = 0;
  double damping_ratio_ = 0;  ///< 2 beta of alpha_n = 2 beta sqrt(m_eff k)
  bool of_moduli_ = false;
  ContactParameters contact_;
};

/// alpha_n/sqrt(m_eff k), so that a binary collision has restitution e: -2 ln e/sqrt(pi^2 + ln^2 e) where the dashpot may pull; where it may not, the
/// collision ends sooner and takes the root of Schwager and Poeschel's closed form (Granular Matter 9, 465, 2007). e = 0 is not reached by any finite
/// damping.
double damping_ratio(double restitution, bool may_pull);

}  // namespace arenite::dem
