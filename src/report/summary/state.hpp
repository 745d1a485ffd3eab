#pragma once
#include <string>

#include "model/result.hpp"

namespace arenite::report {

/// A stored state: its time, walls, balance, energies and boundaries.
template <int D> Numbers state_of(const SnapshotIn<D>& snapshot);

/// How the last state of a stage stands, for people: its balance, its grains by material, the forces on its walls.
template <int D> std::string state_text(const StageResultIn<D>& last);

}  // namespace arenite::report
