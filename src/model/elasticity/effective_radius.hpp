#pragma once
#include <cmath>

namespace arenite::elasticity {

/// r_eff of two disks in the geometrical adhesion gamma sqrt(r_eff h) (T eq. 1.22). Equal cylinders, as the thesis pulled
/// apart, do not tell the three forms apart.
enum class EffectiveRadius { four_reduced, sum, geometric_mean };

/// 4 r_i r_j/(r_i + r_j), r_i + r_j or 2 sqrt(r_i r_j), m; each is 2 r for equal radii r.
inline double effective_radius(EffectiveRadius kind, double radius_i, double radius_j) {
  switch (kind) {
    case EffectiveRadius::sum: return radius_i + radius_j;
    case EffectiveRadius::geometric_mean: return 2 * std::sqrt(radius_i * radius_j);
    case EffectiveRadius::four_reduced: break;
  }
  return 4 * radius_i * radius_j / (radius_i + radius_j);
}

}  // namespace arenite::elasticity
