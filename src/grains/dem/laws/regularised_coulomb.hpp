#pragma once
#include "grains/dem/laws/parts.hpp"

namespace arenite::dem {

/// Smooth grains.
struct NoFriction : NoLaw {
  static constexpr Word word{"none", "smooth grains"};
  static constexpr bool remembers = false;

  template <class V, class T> T tangential(const Slip<V, T>& /*slip*/, T& /*memory*/) const { return T{}; }
  template <class V, class T> V energy(const Slip<V, T>& /*slip*/, T /*memory*/) const { return V(0.0); }
  double tangent(double /*stiffness*/) const { return 0; }
  double damping(double /*viscosity*/) const { return 0; }
};

/// Regularised Coulomb friction, F_t = -min(gamma_s |v_s|, cap) sign(v_s) (T eq. 1.27). It holds no static friction: at
/// rest F_t = 0.
struct RegularisedCoulomb : WithoutParameters {
  static constexpr Word word{"regularised_coulomb", "-min(gamma_s |v_s|, mu |F_n|) sign(v_s): no static friction"};
  static constexpr bool remembers = false;

  template <class V, class T> T tangential(const Slip<V, T>& slip, T& /*memory*/) const {
    using lane::within;
    return T{} - within(slip.viscosity * slip.velocity, slip.cap);
  }
  /// Stores nothing.
  template <class V, class T> V energy(const Slip<V, T>& /*slip*/, T /*memory*/) const { return V(0.0); }
  double tangent(double /*stiffness*/) const { return 0; }
  double damping(double viscosity) const { return viscosity; }
};

}  // namespace arenite::dem
