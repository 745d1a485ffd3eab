#pragma once
#include <string>
#include <vector>

#include "model/phase_map.hpp"
#include "model/stress_field.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/cut.hpp"
#include "solid/peridynamics/loading.hpp"
#include "solid/peridynamics/overstretch.hpp"
#include "solid/peridynamics/pull_state.hpp"
#include "solid/peridynamics/watch.hpp"

namespace arenite::peridynamics {

struct DamageOptions {
  Stiffness stiffness{};
  Toughness toughness{};
  Loading loading = Loading::tension;
  LowerEdge lower = LowerEdge::fixed;
  std::vector<Cut> cuts{};
  double tolerance = 1e-6;  ///< of each static solve
  double max_strain = 1;    ///< the pull ends here,
  double end_stress = 0.1;  ///< or when the stress has fallen to this share of the largest,
  int max_events = 10'000;  ///< or after so many rounds of breaking
  /// Bonds within this share of the most overstretched break in the same round.
  double band = 0.05;
  Watch watch{};
  /// Called before each round of breaking and, with that round's state, where the watch stopped the work.
  KeepPull keep{};
  /// Goes on from here, a state of a pull of the same map with the same options: the result has the same bits as that
  /// of a pull in one piece.
  const PullState* resume = nullptr;
};

struct DamageResult {
  enum class Ending {
    severed,
    dropped,
    strain_reached,
    events_reached,
    not_converged,
    stopped,
    no_path
  } ending = Ending::no_path;
  std::string sentence;
  std::vector<DamageState> curve;
  std::vector<BrokenBond> broken;  ///< in order
  StressField at_strength;         ///< the field when the stress was largest; size 0 if nothing carried
  double strength = 0;             ///< largest stress, Pa
  double modulus = 0;              ///< of the whole sample, Pa
  /// Largest |work - elastic - released| over the work: work from the clamp's force, energies from the bonds.
  double energy_defect = 0;
  int solves = 0, iterations = 0;
};

/// How a pull ended and what came of it, in words.
std::string sentence_of(const DamageResult& result);

/// Moves the top row, quasi-statically, breaking bonds as they reach the critical stretch of their type. Loads are
/// found, not stepped: between two breaks the response is linear, so the next break is known exactly. Bonds break in
/// stretch only, under compression and shear too; broken faces do not touch again. Under compression a sample splits
/// into columns, which carry on: bound such a run by its strain or its rounds. Throws InputError for a map or
/// options that make no sense and for a state of a map of another size.
DamageResult pull_to_failure(const PhaseMap& map, const DamageOptions& options);

}  // namespace arenite::peridynamics
