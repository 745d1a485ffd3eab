#pragma once
#include <string>

#include "grains/lammps/deck.hpp"

namespace arenite::lammps {

/// Lines that move the sides of a sample: walls as planes that go their ways, periodic cells by `fix deform`. A side
/// under a load goes in or out at (aim - load)/c, without the mass that it has here: c grows from a small one, at which
/// the loose sample is closed quickly, to the impedance at which the walls here swallow its waves, as the load comes to
/// a tenth of the aim. So it is LAMMPS's way to the same load, not the same way.
template <int D> std::string side_lines(const dem::SampleIn<D>& sample, const Task& task);

/// Whether LAMMPS is to move it by a load.
template <int D> bool is_pressed(const dem::SampleIn<D>& sample, int side) {
  return sample.wall[side].drive.kind == dem::DriveKind::force;
}

/// Sides with a wall whose way LAMMPS has to add up.
template <int D> std::string pressed_walls(const dem::SampleIn<D>& sample, const char* before, const char* after);

/// What LAMMPS compares with 0: true as long as a load is off its aim by more than a share.
template <int D> std::string loads_are_off(const dem::SampleIn<D>& sample, double share);

}  // namespace arenite::lammps
