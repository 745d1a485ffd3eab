#pragma once
#include <array>
#include <string>
#include <vector>

#include "grains/dem/parameters.hpp"
#include "grains/dem/stage.hpp"
#include "model/domain.hpp"

namespace arenite::dem {

/// One step of a stage's loading: what every side aims at when the increment is over.
struct Increment {
  std::array<SideDrive, 4> side;
  std::string label;
};

/// What the sides of a stage aim at with a share (0 to 1) of the way from the start's forces (N) done; pressures act in full
/// from the start.
Increment on_the_ramp(const Stage& stage, const std::array<double, 4>& force_at_start, double share, std::string label = {});

/// The increments of a stage, in order. Forces go from what acts at the start (N; compression positive) to their values
/// in equal steps, pressures act in full at once; cycles follow, each half cycle a ramp of its own.
std::vector<Increment> increments_of(const Stage& stage, const std::array<double, 4>& force_at_start);

/// What drives the walls of this domain in an increment: velocities along +x or +y, pressures as forces.
WallDrives drives_for(const Increment& increment, const Domain& domain);

}  // namespace arenite::dem
