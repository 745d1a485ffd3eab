#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/engine.hpp"

namespace arenite::lammps {

/// What LAMMPS says of a sample that it carried on: of the grains in their order, of pairs that touch and of walls.
template <int D> struct CarriedIn {
  std::int64_t steps = 0;
  DomainIn<D> domain;  ///< its walls' places
  std::vector<Vec<D>> position, velocity, force;
  std::vector<Turning<D>> omega;
  struct Touch {
    std::int32_t i = 0, j = 0;  ///< i < j; of a wall j = wall_partner(side)
    Vec<D> on_i;                ///< N
  };
  std::vector<Touch> contacts;
};

/// How our own forces agree with LAMMPS's at the same places, speeds and friction springs.
struct Agreement {
  double largest = 0;                       ///< difference of the resultant on a grain over the mean force of a contact
  double unbalanced = 0;                    ///< by our own forces
  std::size_t contacts = 0, not_there = 0;  ///< ours; and those that only one of the two has
};

/// Puts an engine, in which a stage has begun, where LAMMPS carried its sample: places, speeds, sides, time, and the
/// springs of friction that give LAMMPS's forces. Angles of grains stay what they were, for LAMMPS keeps none. All
/// forces are computed anew.
template <int D> Agreement take_over(dem::EngineIn<D>& engine, const CarriedIn<D>& carried);

}  // namespace arenite::lammps
