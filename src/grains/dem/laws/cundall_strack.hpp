#pragma once
#include "grains/dem/laws/parts.hpp"

namespace arenite::dem {

/// Cundall-Strack friction: a tangential spring k_t xi and a dashpot gamma_s v_s, together held within Coulomb's cap;
/// the spring alone never exceeds the cap, so sliding dissipates and never charges it.
///
/// xi is the integral of v_s by the trapezoidal rule, which is of second order. One number a contact is enough for it:
/// `memory` = xi + lag v_s, to which the next evaluation adds lead v_s. Where velocities are those of the middle of a
/// step (leapfrog), lead = dt and lag = 0.
struct CundallStrack : WithoutParameters {
  static constexpr Word word{"cundall_strack", "spring with the Coulomb limit: sustains static friction"};
  static constexpr bool remembers = true;

  template <class V, class T> [[gnu::always_inline]] T tangential(const Slip<V, T>& slip, T& memory) const {
    using lane::within;
    const T pull = within(slip.stiffness * (memory + slip.lead * slip.velocity), slip.cap);
    memory = pull / slip.stiffness + slip.lag * slip.velocity;
    return T{} - within(pull + slip.viscosity * slip.velocity, slip.cap);
  }
  /// xi at the last evaluation, which saw this slip.
  template <class V, class T> T spring(const Slip<V, T>& slip, T memory) const {
    return memory - slip.lag * slip.velocity;
  }
  template <class V, class T> V energy(const Slip<V, T>& slip, T memory) const {
    using lane::dot;
    const T xi = spring(slip, memory);
    return dot(V(0.5) * slip.stiffness * xi, xi);
  }
  double tangent(double stiffness) const { return stiffness; }
  double damping(double viscosity) const { return viscosity; }
  double recall(double force, double stiffness) const { return -force / stiffness; }
};

}  // namespace arenite::dem
