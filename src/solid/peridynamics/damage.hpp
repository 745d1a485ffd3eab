#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/phase_map.hpp"
#include "model/result.hpp"
#include "solid/peridynamics/failure_state.hpp"

namespace arenite::peridynamics {

struct DamageOutcome : FailureRecord {
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
};
template <int D> struct DamageResultIn : DamageOutcome {
  StressIn<D> at_strength;  ///< the field when the stress was largest; size 0 if nothing carried
};
using DamageResult = DamageResultIn<2>;

/// An ending as files name it and as a sentence says it, in the order of DamageOutcome::Ending.
struct DamageEnding {
  const char *word, *phrase;
};
inline constexpr DamageEnding damage_endings[] = {{"severed", "the sample was severed"},
                                                  {"dropped", "the stress fell to the fraction at which the test ends"},
                                                  {"strain_reached", "the largest strain was reached"},
                                                  {"events_reached", "the largest number of rounds was reached"},
                                                  {"not_converged", "a static solve did not converge"},
                                                  {"stopped", "stopped"},
                                                  {"no_path", "the lower clamp is not connected to the upper one"}};

/// Moves the upper clamp, quasi-statically, breaking bonds as they reach the critical stretch of their type. Loads are
/// found, not stepped: between two breaks the response is in proportion to the load, because cracks close without a
/// gap, so the next break is known exactly. Bonds break in stretch only, under compression and shear too; faces that
/// have parted push where they meet again, unless cracks are to stay open. Under compression a sample splits into
/// columns, which carry on: bound such a run by its strain or its rounds. Throws InputError for a map or options that
/// make no sense and for a state of a map of another size.
template <int D> DamageResultIn<D> load_to_failure(const MapIn<D>& map, const DamageOptionsIn<D>& options);
inline DamageResult load_to_failure(const PhaseMap& map, const DamageOptions& options) {
  return load_to_failure<2>(map, options);
}

}  // namespace arenite::peridynamics
