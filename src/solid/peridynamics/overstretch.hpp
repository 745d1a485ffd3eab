#pragma once
#include <array>
#include <vector>

#include "solid/peridynamics/each_bond.hpp"

namespace arenite::peridynamics {

/// Fracture toughness of the bond types, Pa m^0.5 (P Table I: K_p = 3.5 K_m, K_i = K_m; K_m sets the load scale).
struct Toughness {
  double matrix = 1, interface = 1, particle = 3.5;
};

/// Stretch at which a bond of Young modulus E and toughness K breaks: sqrt(4 pi G/(9 E h)), G = K^2/E, h = 3 dx, plane
/// stress.
double critical_stretch(double toughness, double young, double dx);

/// Critical stretch by BondType; that of `no_bond` is 0. Throws InputError for a toughness that is not positive.
std::array<double, 4> critical_stretches(const Toughness& toughness, const Stiffness& stiffness, double dx);

/// How near the bonds of a sample are to breaking.
class Overstretch {
 public:
  Overstretch(const Bonds& bonds, double dx, const std::array<double, 4>& critical, const Field<double>& u)
      : bonds_(bonds), dx_(dx), critical_(critical), u_(u), by_row_(static_cast<std::size_t>(bonds.grid.height)) {}

  /// Linearised stretch over the critical one.
  double ratio(const Bond& b) const {
    const Offset e = b.step();
    return (e.x * (u_.x[b.j] - u_.x[b.i]) + e.y * (u_.y[b.j] - u_.y[b.i])) /
           ((e.x * e.x + e.y * e.y) * dx_ * critical_[b.type]);
  }

  /// Largest ratio of all bonds, 0 where none is stretched. Notes it row by row for `each_above`.
  double largest();

  /// Bonds whose ratio is `limit` or more, as `largest` last saw them, in order: `visit(Bond, ratio)`.
  template <class Visit>
  void each_above(double limit, const Visit& visit) const {
    for (int y = 0; y < bonds_.grid.height; ++y)
      if (by_row_[static_cast<std::size_t>(y)] >= limit)
        each_bond_of_row(bonds_, y, [&](const Bond& b) {
          if (const double r = ratio(b); r >= limit) visit(b, r);
        });
  }

 private:
  const Bonds& bonds_;
  double dx_;
  std::array<double, 4> critical_;
  const Field<double>& u_;
  std::vector<double> by_row_;
};

}  // namespace arenite::peridynamics
