#pragma once
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "grains/dem/laws/capillary.hpp"
#include "grains/dem/laws/cundall_strack.hpp"
#include "grains/dem/laws/dmt.hpp"
#include "grains/dem/laws/geometrical_adhesion.hpp"
#include "grains/dem/laws/hertz_mindlin.hpp"
#include "grains/dem/laws/linear.hpp"
#include "grains/dem/laws/parallel_bond.hpp"
#include "grains/dem/laws/regularised_coulomb.hpp"
#include "grains/dem/laws/rolling.hpp"

namespace arenite::dem {

// What a law must give, for each of the three families. A law is a value that is written once over a number type; it
// sees overlap, normal speed, slip and what it remembers of one contact, never a direction or a place.

/// What every law gives: its word in recipes, its own parameters (name, unit, range and sentence each), equality.
template <class L>
concept ContactLaw = std::default_initializable<L> && std::equality_comparable<L> &&
    requires(L law, ParameterVisitor& visitor) {
  { L::word } -> std::convertible_to<Word>;
  { law.declare(visitor) } -> std::same_as<void>;
};

/// A normal law gives force and energy of an overlap h > 0, so that a test can hold one against the other's gradient. A
/// law that remembers has one number a contact, which `elastic` brings up to date, and the number of a contact that is
/// met at rest.
template <class L>
concept NormalContact = ContactLaw<L> && requires(const L law, double v, double& memory) {
  { law.elastic(v, v, v, memory) } -> std::same_as<double>;  // (h, stiffness, curvature, memory), N
  {
    law.energy(v, v, v, v)
    } -> std::same_as<double>;  // (h, stiffness, curvature, memory): what `elastic` gives back, J; 0 at h = 0
  { law.damping_factor(v, v) } -> std::same_as<double>;  // (h, curvature): share of alpha_n with which the dashpot acts
  {
    law.pull_off(v, v, v)
    } -> std::same_as<double>;  // (strength, stiffness, curvature): greatest net pull against an attraction strength
                                // sqrt(h), N
  {
    law.tangent(v, v, v)
    } -> std::same_as<double>;  // (h, stiffness, curvature): largest slope on [0, h], N/m, for the stable step
  requires(!L::remembers) || requires {
    { law.recall(v, v, v, v) } -> std::same_as<double>;
  };  // (force, h, stiffness, curvature)
};

/// A normal law of materials' E and nu, whose pairs have k = (4/3) E* R*, also says with what the spring of friction
/// grows.
template <class L>
concept ElasticContact = NormalContact<L> && requires(const L law, double v) {
  { law.sliding_base(v, v, v) } -> std::same_as<double>;  // (h, stiffness, curvature), N/m
};

/// An adhesion gives the attraction of two glued grains, >= 0, its potential, <= 0 and 0 at h = 0, and whether glue
/// breaks for good.
template <class L>
concept AdhesiveContact = ContactLaw<L> && requires(const L law, double v) {
  { law.attraction(v, v) } -> std::same_as<double>;  // (h, strength), N
  { law.energy(v, v) } -> std::same_as<double>;      // (h, strength), J
  { L::attracts } -> std::convertible_to<bool>;
  { L::breaks } -> std::convertible_to<bool>;
};

/// A friction law gives the force along the contact, in the plane and in space, and may keep one slip a contact. What
/// it remembers is carried along when contacts are listed anew, and `recall` gives it for a contact that is met at
/// rest.
template <class L>
concept TangentialContact = ContactLaw<L> &&
    requires(const L law, double v, double& memory, Slip<double> slip, Slip<double, Vec3> in_space, Vec3& path) {
  { law.tangential(slip, memory) } -> std::same_as<double>;  // N
  { law.tangential(in_space, path) } -> std::same_as<Vec3>;
  { law.energy(slip, memory) } -> std::same_as<double>;  // what the force at this memory gives back, J
  { law.tangent(v) } -> std::same_as<double>;            // (k_t): largest slope in the slip, N/m, for the stable step
  { law.damping(v) } -> std::same_as<double>;            // (gamma_s): largest slope in its velocity, N s/m
  requires(!L::remembers) || requires {
    { law.recall(v, v) } -> std::same_as<double>;
  };  // (force, k_t)
};

/// Rolling resistance gives a moment against the turning of two grains, in which Slip counts rad/s, N m s, N m and N
/// m/rad.
template <class L>
concept RollingContact = ContactLaw<L> &&
    requires(const L law, double v, double& memory, Slip<double> turning, Slip<double, Vec3> in_space, Vec3& path) {
  { law.coefficient } -> std::convertible_to<double>;              // mu_r: the moment is at most mu_r R F_n
  { law.twisting } -> std::convertible_to<std::optional<double>>;  // mu_t: the same of spheres that twist
  { law.stiffness(v, v) } -> std::same_as<double>;                 // (k_n, R), N m/rad
  { law.damping(v, v, v, v) } -> std::same_as<double>;             // (alpha_n, R, stiffness, reduced inertia), N m s
  { law.moment(turning, memory) } -> std::same_as<double>;         // N m
  { law.moment(in_space, path) } -> std::same_as<Vec3>;
  { law.energy(turning, memory) } -> std::same_as<double>;  // what the moment at this memory gives back, J
  { L::remembers } -> std::convertible_to<bool>;
};

/// A bond gives the beam between two grains, the forces and the energy of its strain, and what its stresses break.
template <class L>
concept BeamLaw = ContactLaw<L> &&
    requires(const L law, double v, const Beam& beam, const BeamStrain<double>& strain, const BeamForce<double>& force,
             const RoundBeam& round, const RoundStrain& turned, const RoundForce& in_space) {
  { law.gap } -> std::convertible_to<double>;      // greatest one that it bridges, over the mean radius
  { law.damping } -> std::convertible_to<double>;  // of its dashpots, over the critical one
  { law.scatter } -> std::convertible_to<double>;  // standard deviation of strengths over their mean, drawn with `seed`
  { law.seed } -> std::convertible_to<std::int64_t>;
  { law.beam(v, v, v) } -> std::same_as<Beam>;  // (length, smaller radius, thickness), m
  { law.elastic(beam, strain) } -> std::same_as<BeamForce<double>>;
  { law.energy(beam, strain) } -> std::same_as<double>;        // J; `elastic` is its gradient
  { law.holds(beam, force, v) } -> std::convertible_to<bool>;  // a bond that is so many times as strong as the law says
  { law.load(beam, force) } -> std::same_as<BeamLoad>;
  { law.round_beam(v, v) } -> std::same_as<RoundBeam>;  // the same between spheres: (length, smaller radius)
  { law.elastic(round, turned) } -> std::same_as<RoundForce>;
  { law.holds(round, in_space, v) } -> std::convertible_to<bool>;
  { law.energy(round, turned) } -> std::same_as<double>;
  { law.load(round, in_space) } -> std::same_as<BeamLoad>;
};

/// A cohesion acts between all disks, beside the contact and beyond it, along the line that joins them. It gives the
/// pull of a pair by its radii and the thickness of the sample, m. Two disks whose gap is less than `joins_within` are
/// joined; where it `breaks` they are so until the curve's reach. One of a liquid whose surfaces must not bulge has
/// `volume` and `largest_volume`.
template <class L>
concept CohesionLaw = ContactLaw<L> && requires(const L law, double v) {
  { L::breaks } -> std::convertible_to<bool>;
  { L::reach_key } -> std::convertible_to<std::string_view>;  // the parameter that makes its reach smaller
  { law.joins_within() } -> std::same_as<double>;             // m
  { law.curve(v, v, v) } -> std::same_as<PullCurve>;
};

/// One law of a family, with its own parameters.
template <class... Law> struct OneOf : std::variant<Law...> {
  using std::variant<Law...>::variant;
  /// Calls `see` with the law by its type.
  template <class See> decltype(auto) visit(See&& see) const { return std::visit(see, *this); }
  std::string_view word() const {
    return visit([](const auto& law) { return law.word.word; });
  }
  /// Whether it is the one that gives no force.
  bool is_none() const {
    return visit([]<class L>(const L&) { return std::derived_from<L, NoLaw>; });
  }
  /// The word of the first law of the family of which `is` is true.
  template <class Is> static std::string_view word_where(const Is& is) {
    std::string_view word;
    static_cast<void>(((is(Law{}) && (word = Law::word.word, true)) || ...));
    return word;
  }
  friend bool operator==(const OneOf& a, const OneOf& b) {
    return static_cast<const std::variant<Law...>&>(a) == static_cast<const std::variant<Law...>&>(b);
  }
};
template <NormalContact... Law> using NormalLaws = OneOf<Law...>;
template <AdhesiveContact... Law> using Adhesions = OneOf<Law...>;
template <TangentialContact... Law> using FrictionLaws = OneOf<Law...>;
template <RollingContact... Law> using RollingLaws = OneOf<Law...>;
template <BeamLaw... Law> using BondLaws = OneOf<Law...>;
template <CohesionLaw... Law> using Cohesions = OneOf<Law...>;

/// The laws there are. A new one is a file beside these and a word here: recipe keys, their documentation and hashes,
/// kernels for every kind of processor and the families' tests follow. The choice is visited outside of the loops, so
/// laws inline into them.
using NormalLaw = NormalLaws<Linear, Hertz, HertzMindlin>;
using Adhesion = Adhesions<NoAdhesion, GeometricalAdhesion, BreakingAdhesion>;
using FrictionLaw = FrictionLaws<NoFriction, RegularisedCoulomb, CundallStrack>;
using RollingLaw = RollingLaws<NoRolling, ConstantTorque, ElasticPlasticRolling>;
using BondLaw = BondLaws<NoBonds, ParallelBond>;
using Cohesion = Cohesions<NoCohesion, Dmt, CapillaryDisks, CapillarySpheres>;

/// The three choices, and the numbers that all contacts share.
struct ContactLaws {
  NormalLaw normal;
  Adhesion adhesion;
  FrictionLaw friction;
  double lead = 0, lag = 0;    ///< of Slip, s
  double stiffness_ratio = 0;  ///< k_t/k_n
  double cap_sign =
      1;  ///< the friction cap is mu (F_n + cap_sign |F_c|): 1 raised by adhesion, -1 as T (1.28) is printed
  bool constant_damping = false;    ///< alpha_n was given as a number: dashpots act with it whatever the overlap
  bool constant_viscosity = false;  ///< gamma_s, or alpha_n for it, was given as a number

  /// Calls `see` with the three laws by their types.
  template <class See> decltype(auto) visit(See&& see) const { return std::visit(see, normal, adhesion, friction); }
  /// The slip that a contact with this k_t has where no force is asked for.
  template <class T> Slip<double, T> slip(T velocity, double stiffness) const {
    return {velocity, 0, 0, stiffness, lead, lag};
  }
};

/// Some law keeps a number a contact.
inline bool remembers(const ContactLaws& laws) {
  return laws.visit(
      [](const auto& normal, const auto&, const auto& friction) { return normal.remembers || friction.remembers; });
}

/// Forces of one contact, N: on i along n and t.
template <class V, class T = V> struct ContactForce {
  V normal;
  T tangential;
};

/// What the laws see of one contact.
template <class V, class T = V> struct ContactState {
  V overlap;    ///< h > 0, m
  V approach;   ///< dh/dt, m/s
  T sliding;    ///< v_s, m/s
  V curvature;  ///< 1/R*, 1/m
  V stiffness;  ///< N/m
  V damping;    ///< alpha_n, N s/m
  V viscosity;  ///< gamma_s, N s/m
  V strength;   ///< gamma sqrt(r_eff) where the pair is glued, else 0
  V friction;   ///< mu
  V floor;      ///< lowest F_n: -infinity, or 0 where the dashpot may not pull
  V shear{};    ///< 4 G*/E*, see HertzMindlin; of other laws not read
};

/// What the laws remember of one contact.
template <class V, class T = V> struct ContactMemory {
  V normal{};
  T slip{};
};

/// k_t of a contact, N/m. `shear` as in ContactState.
template <class V, NormalContact N>
inline V sliding_stiffness(const ContactLaws& shared, const N& normal, V overlap, V stiffness, V curvature, V shear) {
  if constexpr (ElasticContact<N>) return shear * normal.sliding_base(overlap, stiffness, curvature);
  else return V(shared.stiffness_ratio) * stiffness;
}

/// The laws composed: F_n = elastic + dashpot - attraction, F_t within mu (F_n + F_c), the cap never below 0.
template <class V, class T, NormalContact N, AdhesiveContact A, TangentialContact F>
inline ContactForce<V, T> contact_force(const ContactLaws& shared, const N& normal, const A& adhesion,
                                        const F& friction, const ContactState<V, T>& c, ContactMemory<V, T>& memory) {
  using lane::max;
  const V elastic = normal.elastic(c.overlap, c.stiffness, c.curvature, memory.normal);
  const V damping = shared.constant_damping ? c.damping : normal.damping_factor(c.overlap, c.curvature) * c.damping;
  const V fn = max(elastic + damping * c.approach - adhesion.attraction(c.overlap, c.strength), c.floor);
  V shift(0.0);
  if constexpr (A::attracts) shift = V(shared.cap_sign) * normal.pull_off(c.strength, c.stiffness, c.curvature);
  const V cap = max(c.friction * (fn + shift), V(0.0));
  V viscosity = c.viscosity;
  if constexpr (ElasticContact<N>)
    if (!shared.constant_viscosity) viscosity = normal.damping_factor(c.overlap, c.curvature) * viscosity;
  const V spring = sliding_stiffness(shared, normal, c.overlap, c.stiffness, c.curvature, c.shear);
  const Slip<V, T> slip{c.sliding, viscosity, cap, spring, V(shared.lead), V(shared.lag)};
  return {fn, friction.tangential(slip, memory.slip)};
}

}  // namespace arenite::dem
