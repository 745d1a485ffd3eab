#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/phase_map.hpp"
#include "model/result.hpp"
#include "solid/peridynamics/failure_state.hpp"

namespace arenite::peridynamics {

struct DamageResult : FailureRecord {
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
  StressField at_strength;  ///< the field when the stress was largest; size 0 if nothing carried
};

/// An ending as files name it and as a sentence says it, in the order of DamageResult::Ending.
struct DamageEnding {
  const char *word, *phrase;
};
inline constexpr DamageEnding damage_endings[] = {{"severed", "the sample was severed"},
                                                  {"dropped", "the stress fell to the fraction at which the test ends"},
                                                  {"strain_reached", "the largest strain was reached"},
                                                  {"events_reached", "the largest number of rounds was reached"},
                                                  {"not_converged", "a static solve did not converge"},
                                                  {"stopped", "stopped"},
                                                  {"no_path", "the bottom row is not connected to the top row"}};

/// Critical stretch by BondType, the lower of those that toughness and strength give on a grid of this spacing; that of
/// `no_bond` is 0. Throws InputError for a toughness or strength that is not positive.
std::array<double, 4> critical_stretches(const DamageOptions& options, double dx);

/// Moves the top row, quasi-statically, breaking bonds as they reach the critical stretch of their type. Loads are
/// found, not stepped: between two breaks the response is in proportion to the load, because cracks close without a
/// gap, so the next break is known exactly. Bonds break in stretch only, under compression and shear too; faces that
/// have parted push where they meet again, unless cracks are to stay open. Under compression a sample splits into
/// columns, which carry on: bound such a run by its strain or its rounds. Throws InputError for a map or options that
/// make no sense and for a state of a map of another size.
DamageResult load_to_failure(const PhaseMap& map, const DamageOptions& options);

/// Broken bonds as cracks: their middles, m from the lower left corner of the map.
std::vector<Crack> cracks_of(const std::vector<BrokenBond>& broken, double dx);

}  // namespace arenite::peridynamics
