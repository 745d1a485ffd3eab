#pragma once
#include <concepts>
#include <variant>

#include "grains/dem/laws/cundall_strack.hpp"
#include "grains/dem/laws/geometrical_adhesion.hpp"
#include "grains/dem/laws/hertz.hpp"
#include "grains/dem/laws/linear.hpp"
#include "grains/dem/laws/regularised_coulomb.hpp"
#include "grains/dem/parameters.hpp"

namespace arenite::dem {

/// A normal law gives force and energy of an overlap h > 0, so that a test can hold one against the other's gradient.
template <class L>
concept NormalContact = requires(const L law, double v) {
  { law.elastic(v, v, v) } -> std::same_as<double>;  // (h, stiffness, curvature), N
  { law.viscous(v, v, v, v) } -> std::same_as<double>;  // (h, dh/dt, damping, curvature), N
  { law.energy(v, v, v) } -> std::same_as<double>;   // J
  { law.pull_off(v, v, v) } -> std::same_as<double>; // (strength, stiffness, curvature), N
  { law.tangent(v, v, v) } -> std::same_as<double>;  // N/m, for the stable step
};

/// An adhesion law gives the attraction of two glued grains, its energy, and what it adds to the friction cap.
template <class L>
concept AdhesiveContact = requires(const L law, double v) {
  { law.attraction(v, v) } -> std::same_as<double>;  // (h, strength), N
  { law.energy(v, v) } -> std::same_as<double>;      // J
  { law.cap_shift(v) } -> std::same_as<double>;      // (pull-off force), N
};

/// A friction law gives the force along t from the sliding velocity, and may keep one number a contact.
template <class L>
concept TangentialContact = requires(const L law, double v, double& memory) {
  { law.tangential(v, v, v, v, memory) } -> std::same_as<double>;  // (v_s, viscosity, cap, stiffness, memory), N
  { law.energy(v, v, v) } -> std::same_as<double>;                 // (v_s, stiffness, memory), J
  { L::remembers } -> std::convertible_to<bool>;
};

/// The laws there are. A new one is a file beside these and a name here; the engine visits the three choices once,
/// outside its loops, so the laws inline into them.
using NormalChoice = std::variant<Linear, Hertz>;
using AdhesionChoice = std::variant<NoAdhesion, GeometricalAdhesion>;
using FrictionChoice = std::variant<RegularisedCoulomb, CundallStrack>;

static_assert(NormalContact<Linear> && NormalContact<Hertz>);
static_assert(AdhesiveContact<NoAdhesion> && AdhesiveContact<GeometricalAdhesion>);
static_assert(TangentialContact<RegularisedCoulomb> && TangentialContact<CundallStrack>);

/// The three choices together with the numbers that they share.
struct ContactLaws {
  NormalChoice normal;
  AdhesionChoice adhesion;
  FrictionChoice friction;
};

/// Forces of one contact, N: on i along n and t.
template <class V>
struct ContactForce {
  V normal, tangential;
};

/// What a law sees of one contact.
template <class V>
struct ContactState {
  V overlap;        ///< h > 0, m
  V approach;       ///< dh/dt, m/s
  V sliding;        ///< v_s, m/s
  V curvature;      ///< 1/R*, 1/m
  V stiffness;      ///< N/m
  V damping;        ///< alpha_n, N s/m
  V viscosity;      ///< gamma_s, N s/m
  V strength;       ///< gamma sqrt(r_eff) where the pair is glued, else 0
  V friction;       ///< mu
  V floor;          ///< lowest F_n: -infinity, or 0 where the dashpot may not pull
};

/// The laws composed: F_n = elastic + dashpot - attraction, F_t within mu (F_n + F_c), the cap never below 0.
template <class V, NormalContact N, AdhesiveContact A, TangentialContact F>
inline ContactForce<V> contact_force(const N& normal, const A& adhesion, const F& friction, const ContactState<V>& c,
                                     V& memory) {
  using lane::max;
  const V elastic = normal.elastic(c.overlap, c.stiffness, c.curvature);
  const V viscous = normal.viscous(c.overlap, c.approach, c.damping, c.curvature);
  const V fn = max(elastic + viscous - adhesion.attraction(c.overlap, c.strength), c.floor);
  const V cap = max(c.friction * (fn + adhesion.cap_shift(normal.pull_off(c.strength, c.stiffness, c.curvature))), V(0.0));
  return {fn, friction.tangential(c.sliding, c.viscosity, cap, c.stiffness, memory)};
}

/// The choices that the parameters ask for; `lead` and `lag` are those of CundallStrack, s.
ContactLaws choose_laws(const ContactParameters& contact, double lead, double lag);

}  // namespace arenite::dem
