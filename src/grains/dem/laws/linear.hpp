#pragma once
#include "grains/dem/laws/lane.hpp"

namespace arenite::dem {

/// Linear spring and dashpot, F_n = k h + alpha_n dh/dt (T eq. 1.23; h > 0 is an overlap, F_n > 0 pushes).
struct Linear {
  /// Conservative force at overlap h; `curvature` = 1/R* is not used.
  template <class V>
  V elastic(V h, V stiffness, V /*curvature*/) const {
    return stiffness * h;
  }
  /// Dashpot at approach rate dh/dt.
  template <class V>
  V viscous(V /*h*/, V approach, V damping, V /*curvature*/) const {
    return damping * approach;
  }
  /// Potential of `elastic`, 0 at h = 0.
  template <class V>
  V energy(V h, V stiffness, V /*curvature*/) const {
    return V(0.5) * stiffness * h * h;
  }
  /// Greatest net pull against an attraction strength sqrt(h), at h = strength^2/(4 k^2) (T eq. 1.25).
  template <class V>
  V pull_off(V strength, V stiffness, V /*curvature*/) const {
    return V(0.25) * strength * strength / stiffness;
  }
  /// Largest d elastic/dh on [0, h].
  double tangent(double /*h*/, double stiffness, double /*curvature*/) const { return stiffness; }
  /// Factor of the dashpot that `viscous` reaches at overlap h.
  double damping_factor(double /*h*/, double /*curvature*/) const { return 1; }
};

}  // namespace arenite::dem
