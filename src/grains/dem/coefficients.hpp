#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "grains/dem/kernels/kernel.hpp"
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
  /// `used`: the materials of grains.
  CoefficientTable(const Materials& materials, const std::vector<std::int32_t>& used, const ContactParameters& contact);

  template <int D> Coefficients pair(const GrainRecord<D>& a, const GrainRecord<D>& b, bool glued) const {
    Coefficients c = with_dashpots(pair_stiffness(a, b), of_pair(a, b).shear, a.mass * b.mass / (a.mass + b.mass));
    if (glued)
      c.strength = contact_.surface_energy *
                   std::sqrt(elasticity::effective_radius(contact_.effective_radius, a.radius, b.radius));
    return c;
  }
  /// m_eff = m.
  template <int D> Coefficients wall(const GrainRecord<D>& d) const {
    return with_dashpots(wall_stiffness(d), wall_[d.material].shear, d.mass);
  }

  /// k; (4/3) E* R* where the law is one of E and nu, N/m.
  template <int D> double pair_stiffness(const GrainRecord<D>& a, const GrainRecord<D>& b) const {
    return of_pair(a, b).stiffness * (of_moduli_ ? a.radius * b.radius / (a.radius + b.radius) : 1.0);
  }
  template <int D> double wall_stiffness(const GrainRecord<D>& d) const {
    return wall_[d.material].stiffness * (of_moduli_ ? d.radius : 1.0);
  }
  /// The largest 4 G*/E* there is.
  double largest_shear() const;

 private:
  struct Spring {
    double stiffness = 0, shear = 0;  ///< k, N/m, of moduli (4/3) E*, Pa; shear as in Coefficients
  };
  template <int D> const Spring& of_pair(const GrainRecord<D>& a, const GrainRecord<D>& b) const {
    return pair_[static_cast<std::size_t>(a.material) * wall_.size() + b.material];
  }
  Coefficients with_dashpots(double stiffness, double shear, double reduced_mass) const;

  std::vector<Spring> pair_, wall_;  ///< by material
  double damping_ratio_ = 0;         ///< 2 beta of alpha_n = 2 beta sqrt(m_eff k)
  bool of_moduli_ = false;
  ContactParameters contact_;
};

/// alpha_n/sqrt(m_eff k), so that a binary collision has restitution e: -2 ln e/sqrt(pi^2 + ln^2 e) where the dashpot
/// may pull; where it may not, the collision ends sooner and takes the root of Schwager and Poeschel's closed form
/// (Granular Matter 9, 465, 2007). e = 0 is not reached by any finite damping.
double damping_ratio(double restitution, bool may_pull);

}  // namespace arenite::dem
