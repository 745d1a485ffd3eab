#pragma once
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/vec.hpp"
#include "solid/peridynamics/laws/laws.hpp"
#include "solid/statics/loading.hpp"
#include "solid/statics/watch.hpp"

/// Bonds between the nodes of a phase map, and what a load does to them (P II.C). Here are the choices.
namespace arenite::peridynamics {

using statics::Loading;
using statics::LowerEdge;
using statics::Progress;
using statics::Watch;

/// E_p over E_m (P Table I).
inline constexpr double particle_modulus_over_matrix = 4;

/// Young moduli of the bond types, Pa (P Table I: E_i = E_m).
struct Stiffness {
  double matrix = 1, interface = 1, particle = particle_modulus_over_matrix;
  /// The micromodulus that gives the lattice's Young modulus along its axes; otherwise P's nominal one (eq. 5).
  bool calibrated = true;
};

/// K_p over K_m (P Table I), which is taken for strengths, too.
inline constexpr double particle_over_matrix = 3.5;

/// Fracture toughness of the bond types, Pa m^0.5 (P Table I: K_i = K_m; K_m sets the load scale).
struct Toughness {
  double matrix = 1, interface = 1, particle = particle_over_matrix;
};

/// Tensile strength of the bond types, Pa: a bond breaks at the lower of the stretches that its toughness and its
/// strength give. Infinite: toughness alone.
struct Strength {
  double matrix = HUGE_VAL, interface = HUGE_VAL, particle = HUGE_VAL;
};

/// A straight cut through all bonds that cross it, in nodes: a notch without width. In space it lies in x and z and
/// goes through all y.
struct Cut {
  Vec2 from, to;
};

/// Ways to the field at equilibrium.
enum class Method {
  static_solve,  ///< conjugate gradients with the two-level preconditioner
  relaxation,    ///< adaptive dynamic relaxation
  damped         ///< P II.C: explicit dynamics under a fixed viscosity below the critical one
};

/// How a sample is held and loaded, whatever is looked for; what a recipe's load says in the same words.
struct LoadCase {
  Loading loading = Loading::tension;
  LowerEdge lower = LowerEdge::fixed;
  double tolerance = 1e-6;  ///< of the residual of each static solve, relative to that of uniform strain
  BondLawChoice law{};
  /// No bond passes through a void node (`bonds.hpp`); otherwise bonds reach across voids thinner than the horizon.
  bool stop_at_voids = false;
  int horizon_in_space = 2;  ///< spacings: 2 for 32 bonds a node, 3 for 122; in the plane it is 3
  bool operator==(const LoadCase&) const = default;
};

/// Steps after which dynamics are given up.
inline constexpr int usual_steps = 1'000'000;

/// How the field at a strain is found.
struct FieldChoices {
  double strain = 1e-4;    ///< displacement of the top row over the distance of the two rows
  int max_iterations = 0;  ///< 0: `usual_steps`; of the static solve `statics::usual_cap`
  /// P's stretch (|xi + eta| - |xi|)/|xi| along the turned bond; otherwise the linearised one.
  bool exact_stretch = false;
  bool operator==(const FieldChoices&) const = default;
};

/// How bonds break, and when a test to failure ends.
struct FailureChoices {
  double max_strain = 1;    ///< the test ends here,
  double end_stress = 0.1;  ///< or when the stress has fallen to this share of the largest
  /// Bonds within this share of the one furthest beyond its critical stretch break in the same round.
  double band = 0.05;
  /// Broken bonds are gone; otherwise faces that have parted push where they meet again.
  bool cracks_stay_open = false;
  bool operator==(const FailureChoices&) const = default;
};

struct LoadOptions : LoadCase, FieldChoices {
  Stiffness stiffness{};
  Watch watch{};
  Method method = Method::static_solve;
  /// Look for hinges in any case; otherwise only where the solve hints at one (a loose node, or many iterations).
  bool look_for_hinges = false;
};

template <int D> struct FailureStateIn;

/// Is handed a way to the state; a caller that wants it asks for it (copying it takes time).
template <int D> using KeepFailureIn = std::function<void(const std::function<FailureStateIn<D>()>& state)>;

/// How a sample of the plane or of space is brought to failure.
template <int D> struct DamageOptionsIn : LoadCase, FailureChoices {
  Stiffness stiffness{};
  Watch watch{};
  Toughness toughness{};
  Strength strength{};
  std::vector<Cut> cuts{};
  int max_events = 10'000;  ///< rounds of breaking after which the test ends
  /// Called before each round of breaking and, with that round's state, where the watch stopped the work.
  KeepFailureIn<D> keep{};
  /// Goes on from here, a state of a test of the same map with the same options: the result has the same bits as that
  /// of a test in one piece.
  const FailureStateIn<D>* resume = nullptr;
};
using DamageOptions = DamageOptionsIn<2>;

}  // namespace arenite::peridynamics
