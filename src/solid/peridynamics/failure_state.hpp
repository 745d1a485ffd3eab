#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// One state of the test: before a round of breaking, so that loads climb and drop as the machine would see them.
struct DamageState {
  double strain = 0, stress = 0;  ///< of the top row along its way, Pa: positive while it is resisted
  double work = 0;                ///< done by the clamp so far; all energies per unit thickness, J/m
  double elastic = 0;
  double released = 0;     ///< elastic energy lost when bonds broke at fixed displacement
  double bond_energy = 0;  ///< of that, what the broken bonds held when they broke; the rest would fly off as waves
  std::size_t broken = 0;
};

struct BrokenBond {
  std::int32_t x, y;       ///< node that it started from
  std::uint8_t direction;  ///< index into half_bonds
  std::uint8_t type;       ///< BondType
  double strain;           ///< of the sample when it broke
};

/// What came of a test so far.
struct FailureRecord {
  std::vector<DamageState> curve;
  std::vector<BrokenBond> broken;  ///< in order
  double strength = 0;             ///< largest stress, Pa
  double modulus = 0;              ///< of the whole sample, Pa
  /// Largest |work - elastic - released| over the work: work from the clamp's force, energies from the bonds.
  double energy_defect = 0;
  int solves = 0, iterations = 0;
};

/// Where a test stands before a round of breaking: all that decides how it goes on, beside its map and options. Arrays
/// by node are padded (grid.hpp); displacements are m at unit strain.
struct FailureState : FailureRecord {
  std::int32_t width = 0, height = 0;    ///< nodes of the map
  std::int64_t rounds = 0;               ///< of breaking so far
  Buffer<std::uint32_t> words;           ///< Bonds::words of whole bonds
  Buffer<std::uint32_t> parted;          ///< the same of bonds whose faces may meet again; empty where cracks stay open
  Buffer<std::uint32_t> words_at_setup;  ///< of what resisted when the solver was set up, which it is still
  Field<double> u;                       ///< the last equilibrium: the next solve starts from it
  DamageState now;
  double share = 0;  ///< Progress::share
  /// What resisted and the equilibrium when the stress was largest; empty before the first round.
  Buffer<std::uint32_t> strongest_words;
  Field<double> strongest_u;
  double strongest_strain = 0;
};

/// The state as bytes and back. Throws InputError if the bytes are not a whole state.
std::vector<std::uint8_t> to_bytes(const FailureState& state);
FailureState failure_state_of(const std::vector<std::uint8_t>& bytes);

}  // namespace arenite::peridynamics
