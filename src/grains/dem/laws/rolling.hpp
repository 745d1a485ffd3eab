#pragma once
#include <optional>

#include "grains/dem/laws/cundall_strack.hpp"
#include "grains/dem/laws/regularised_coulomb.hpp"

namespace arenite::dem {

// Rolling resistance (Ai, Chen, Rotter and Ooi, Powder Technology 206, 269, 2011): a moment against theta' = omega_i -
// omega_j that never exceeds mu_r R F_n, R = r_i r_j/(r_i + r_j), at a wall r_i. As a law it is one of friction that
// sees turning for sliding: rad/s, N m s, N m, N m/rad; in space a vector without the twist about the normal. That is
// resisted by the same law with a coefficient mu_t of its own.

/// Discs roll freely.
struct NoRolling : NoLaw {
  static constexpr Word word{"none", "grains roll freely"};
  static constexpr bool remembers = false;

  double coefficient = 0;
  std::optional<double> twisting = {};
  template <class V> V stiffness(V /*normal*/, V /*radius*/) const { return V(0.0); }
  template <class V> V damping(V /*normal*/, V /*radius*/, V /*stiffness*/, V /*inertia*/) const { return V(0.0); }
  template <class V, class T> T moment(const Slip<V, T>& /*turning*/, T& /*memory*/) const { return {}; }
  template <class T> double energy(const Slip<double, T>& /*turning*/, T /*memory*/) const { return 0; }
};

/// The parameter of resistance to twisting.
inline void declare_twisting(ParameterVisitor& v, std::optional<double>& coefficient) {
  v.number({"twisting_friction",
            "Coefficient mu_t of the resistance of spheres to turning about the line between them, by the same law; "
            "none unless given."},
           coefficient, "", range::not_negative);
}

/// A law of rolling as one of twisting.
template <class Law> Law against_twisting(Law law) {
  law.coefficient = law.twisting.value_or(0);
  return law;
}

/// Constant torque (type A): the full moment against the turning, below mu_r R F_n only where turning is so slow that
/// the normal damping times R^2 would give less.
struct ConstantTorque {
  static constexpr Word word{"constant_torque", "mu_r R F_n against the relative rotation"};
  static constexpr bool remembers = false;
  void declare(ParameterVisitor& v) {
    v.number({"rolling_friction", "Coefficient mu_r of rolling resistance."}, coefficient, "", range::not_negative);
    declare_twisting(v, twisting);
  }
  bool operator==(const ConstantTorque&) const = default;

  double coefficient = 0.1;
  std::optional<double> twisting = {};
  template <class V> V stiffness(V /*normal*/, V /*radius*/) const { return V(0.0); }
  template <class V> V damping(V normal, V radius, V /*stiffness*/, V /*inertia*/) const {
    return normal * radius * radius;
  }
  template <class V, class T> T moment(const Slip<V, T>& turning, T& memory) const {
    return RegularisedCoulomb{}.tangential(turning, memory);
  }
  template <class T> double energy(const Slip<double, T>& /*turning*/, T /*memory*/) const { return 0; }
};

/// Elastic-plastic spring (type C): k_r = 2.25 k_n (mu_r R)^2 with a dashpot of a share of its critical damping,
/// together within mu_r R F_n. It holds a grain at rest.
struct ElasticPlasticRolling {
  static constexpr Word word{"elastic_plastic", "spring of 2.25 k_n (mu_r R)^2 that yields at mu_r R F_n"};
  static constexpr bool remembers = true;
  void declare(ParameterVisitor& v) {
    v.number({"rolling_friction", "Coefficient mu_r of rolling resistance."}, coefficient, "", range::not_negative);
    v.number({"rolling_damping", "Damping of the rolling spring, as a fraction of critical damping."}, damping_share,
             "", range::not_negative);
    declare_twisting(v, twisting);
  }
  bool operator==(const ElasticPlasticRolling&) const = default;

  double coefficient = 0.1, damping_share = 0.3;
  std::optional<double> twisting = {};
  template <class V> V stiffness(V normal, V radius) const {
    return V(2.25) * normal * V(coefficient) * V(coefficient) * radius * radius;
  }
  template <class V> V damping(V /*normal*/, V /*radius*/, V stiffness, V inertia) const {
    using lane::sqrt;
    return V(2 * damping_share) * sqrt(inertia * stiffness);
  }
  template <class V, class T> T moment(const Slip<V, T>& turning, T& memory) const {
    using lane::select;
    const auto springs = turning.stiffness > V(0.0);
    T moved = memory;
    const T moment = CundallStrack{}.tangential(turning, moved);
    memory = select(springs, moved, memory);
    return select(springs, moment, T{});
  }
  template <class T> double energy(const Slip<double, T>& turning, T memory) const {
    return CundallStrack{}.energy(turning, memory);
  }
};

}  // namespace arenite::dem
