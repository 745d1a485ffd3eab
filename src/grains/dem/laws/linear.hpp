#pragma once
#include "grains/dem/laws/parts.hpp"

namespace arenite::dem {

/// Linear spring and dashpot, F_n = k h + alpha_n dh/dt (T eq. 1.23; h > 0 is an overlap, F_n > 0 pushes).
struct Linear : WithoutParameters {
  static constexpr Word word{"linear", "spring k_eff h and dashpot"};
  static constexpr bool remembers = false;

  template <class V> V elastic(V h, V stiffness, V /*curvature*/, V& /*memory*/) const { return stiffness * h; }
  template <class V> V energy(V h, V stiffness, V /*curvature*/, V /*memory*/) const {
    return V(0.5) * stiffness * h * h;
  }
  template <class V> V damping_factor(V /*h*/, V /*curvature*/) const { return V(1.0); }
  /// At h = strength^2/(4 k^2) (T eq. 1.25).
  template <class V> V pull_off(V strength, V stiffness, V /*curvature*/) const {
    return V(0.25) * strength * strength / stiffness;
  }
  double tangent(double /*h*/, double stiffness, double /*curvature*/) const { return stiffness; }
};

}  // namespace arenite::dem
