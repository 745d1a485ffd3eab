#pragma once
#include "grains/dem/laws/lane.hpp"

namespace arenite::dem {

/// Cundall-Strack friction: a tangential spring k_t xi and a dashpot gamma_s v_s, together held within Coulomb's cap;
/// the spring alone never exceeds the cap, so sliding dissipates and never charges it.
///
/// xi is the integral of v_s by the trapezoidal rule, which is of second order. One number a contact is enough for it:
/// `memory` = xi + lag v_s, to which the next evaluation adds lead v_s. Where velocities are those of the middle of a
/// step (leapfrog), lead = dt and lag = 0.
struct CundallStrack {
  static constexpr bool remembers = true;
  double ratio = 0.8;          ///< k_t/k_n
  double lead = 0, lag = 0;    ///< s

  template <class V>
  V tangential(V sliding, V viscosity, V cap, V stiffness, V& memory) const {
    using lane::within;
    const V kt = V(ratio) * stiffness;
    const V pull = within(kt * (memory + V(lead) * sliding), cap);
    memory = pull / kt + V(lag) * sliding;
    return V(0.0) - within(pull + viscosity * sliding, cap);
  }
  /// xi at the last evaluation, which saw this sliding velocity.
  double spring(double sliding, double memory) const { return memory - lag * sliding; }
  double energy(double sliding, double stiffness, double memory) const {
    const double xi = spring(sliding, memory);
    return 0.5 * ratio * stiffness * xi * xi;
  }
  double stiffness_ratio() const { return ratio; }
};

}  // namespace arenite::dem
