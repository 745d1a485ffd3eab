#pragma once
#include <cmath>

#include "grains/dem/laws/parts.hpp"

namespace arenite::dem {

/// Hertz contact, F = k h sqrt(h/R*) with 1/R* = 1/r_i + 1/r_j (wall: 1/r_i). For spheres k = (4/3) E* R*, so k is the
/// secant stiffness that the contact would have at h = R*; at h/R* = 1 % it is a tenth of that. The dashpot grows as
/// the square root of the tangent stiffness S = (3/2) k sqrt(h/R*), because then restitution does not depend on
/// velocity: alpha = 2 beta sqrt(5/6) sqrt(m_eff S), beta = -ln e/sqrt(pi^2 + ln^2 e), which is the linear law's 2 beta
/// sqrt(m_eff k) times sqrt(5/4) (h/R*)^(1/4).
struct Hertz : WithoutParameters {
  static constexpr Word word{"hertz", "spring growing with h^(3/2)"};
  static constexpr bool remembers = false;

  template <class V> V elastic(V h, V stiffness, V curvature, V& /*memory*/) const {
    using lane::sqrt;
    return stiffness * h * sqrt(h * curvature);
  }
  template <class V> V energy(V h, V stiffness, V curvature, V /*memory*/) const {
    using lane::sqrt;
    return V(0.4) * stiffness * h * h * sqrt(h * curvature);
  }
  template <class V> V damping_factor(V h, V curvature) const {
    using lane::sqrt;
    return V(1.118033988749895) * sqrt(sqrt(h * curvature));
  }
  /// At h = strength sqrt(R*)/(3 k).
  template <class V> V pull_off(V strength, V stiffness, V curvature) const {
    using lane::sqrt;
    return V(2.0 / 3.0) * strength * sqrt(strength / (V(3.0) * stiffness * sqrt(curvature)));
  }
  double tangent(double h, double stiffness, double curvature) const {
    return 1.5 * stiffness * std::sqrt(h * curvature);
  }
};

}  // namespace arenite::dem
