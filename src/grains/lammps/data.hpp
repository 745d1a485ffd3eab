#pragma once
#include <string>

#include "grains/dem/sample.hpp"

namespace arenite::lammps {

/// The grains and their container as a data file of LAMMPS's atom style sphere. A disk has the density of the sphere
/// that weighs as much.
template <int D> std::string data_of(const dem::SampleIn<D>& sample, const std::string& title);

/// A vector of either dimension in LAMMPS's three; what turns in the plane turns about z.
inline Vec3 in_space(Vec2 v) { return {v.x, v.y, 0}; }
inline Vec3 in_space(Vec3 v) { return v; }
inline Vec3 turning_in_space(double omega) { return {0, 0, omega}; }
inline Vec3 turning_in_space(Vec3 omega) { return omega; }

}  // namespace arenite::lammps
