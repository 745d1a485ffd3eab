#pragma once
#include <cstdint>
#include <string>

#include "grains/dem/sample.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::lammps {

/// What LAMMPS is to do with a sample: one leg of a stage.
struct Task {
  std::string title;
  dem::Leg leg;            ///< what the sides aim at
  std::int64_t steps = 0;  ///< so many, or at most so many where it is to come to rest
  bool to_rest = false;    ///< it ends where the grains and the loads are as `rest` asks
  dem::EquilibriumCriterion rest;
  std::int64_t restart_every = 10000;  ///< steps between two restart files
};

/// The files that LAMMPS reads: the sample, the input, and a script that tells an input that goes on from a restart
/// file where the walls were.
struct Deck {
  std::string data, input, walls;
};

/// Names in the deck's folder, of what LAMMPS writes: the last state of grains and of pairs, what else there is to
/// say of it, written last; and a file that is there once the sample is read.
namespace names {
inline constexpr const char *data = "sample.data", *input = "in.lammps", *walls = "walls.sh", *state = "state.dump",
                            *pairs = "pairs.dump", *ended = "ended", *begun = "begun", *log = "log.lammps";
}

/// The deck for a sample that a stage has begun with and that is driven as the leg says. Grain k is atom k + 1, its
/// type the place of its material + 1.
template <int D> Deck deck_of(const dem::SampleIn<D>& sample, const Task& task);

/// The fix by which a wall pushes the grains of a material.
std::string wall_fix(int side, int material);

}  // namespace arenite::lammps
