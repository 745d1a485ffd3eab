#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solid/peridynamics/failure_bonds.hpp"

namespace arenite::peridynamics {

/// One state of the test: before a round of breaking, so that loads climb and drop as the machine would see them.
struct DamageState {
  double strain = 0, stress = 0;  ///< of the top row along its way, Pa: positive while it is resisted
  double work = 0;                ///< done by the clamp so far; energies in J, in the plane per unit thickness, J/m
  double elastic = 0;
  double released = 0;     ///< elastic energy lost when bonds broke at fixed displacement
  double bond_energy = 0;  ///< of that, what the broken bonds held when they broke; the rest would fly off as waves
  std::size_t broken = 0;
};

struct BrokenBond {
  std::int32_t x, y, z;    ///< node that it started from; z is 0 in the plane
  std::uint8_t direction;  ///< index into half_bonds, or SpaceBonds::half
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
template <int D> struct FailureStateIn : FailureRecord {
  std::array<std::int32_t, 3> size{};  ///< nodes of the map along x, y, z
  std::int64_t rounds = 0;             ///< of breaking so far
  WordsIn<D> words;                    ///< of whole bonds
  WordsIn<D> parted;                   ///< of bonds whose faces may meet again; empty where cracks stay open
  WordsIn<D> words_at_setup;           ///< of what resisted when the solver was set up, which it is still
  statics::FieldIn<D, double> u;       ///< the last equilibrium: the next solve starts from it
  DamageState now;
  double share = 0;  ///< Progress::share
  /// What resisted and the equilibrium when the stress was largest; empty before the first round.
  WordsIn<D> strongest_words;
  statics::FieldIn<D, double> strongest_u;
  double strongest_strain = 0;
};
using FailureState = FailureStateIn<2>;

/// The state as bytes and back. Throws InputError if the bytes are not a whole state of this dimension.
template <int D> std::vector<std::uint8_t> to_bytes(const FailureStateIn<D>& state);
template <int D = 2> FailureStateIn<D> failure_state_of(const std::vector<std::uint8_t>& bytes);

}  // namespace arenite::peridynamics
