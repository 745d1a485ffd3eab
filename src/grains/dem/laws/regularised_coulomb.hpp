#pragma once
#include "grains/dem/laws/lane.hpp"

namespace arenite::dem {

/// Regularised Coulomb friction, F_t = -min(gamma_s |v_s|, cap) sign(v_s) (T eq. 1.27). It holds no static friction:
/// at rest F_t = 0.
struct RegularisedCoulomb {
  static constexpr bool remembers = false;

  /// Force along t at sliding velocity v_s; `memory` is not touched.
  template <class V>
  V tangential(V sliding, V viscosity, V cap, V /*stiffness*/, V& /*memory*/) const {
    using lane::within;
    return V(0.0) - within(viscosity * sliding, cap);
  }
  /// Stores nothing.
  double energy(double /*sliding*/, double /*stiffness*/, double /*memory*/) const { return 0; }
  double spring(double /*sliding*/, double /*memory*/) const { return 0; }
  double stiffness_ratio() const { return 0; }
};

}  // namespace arenite::dem
