#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/load.hpp"

namespace arenite::peridynamics {

/// What the explicit ways need beside the bonds.
struct Dynamics {
  const Bonds& bonds;
  const std::vector<std::uint8_t>& prescribed;
  double dx;
  bool exact_stretch;
  double tolerance;  ///< relative residual, as in the static solve
  std::int64_t max_steps;
  const Watch& watch;
};

/// P II.C: m u'' = f - nu u', unit mass, viscosity 0.9 of the critical sqrt(2 m k) of the softest bond, central
/// differences at 0.9 of the stable step. `u` holds prescribed displacements and the start, and then the end.
StaticReport damped_dynamics(const Dynamics& dynamics, Field<double>& u);

/// Adaptive dynamic relaxation: the mass of a node is its own 2 x 2 stiffness, so that one step fits all; the damping
/// is critical for the frequency that the Rayleigh quotient of the velocities shows (P. Underwood, 1983).
StaticReport adaptive_relaxation(const Dynamics& dynamics, Field<double>& u);

}  // namespace arenite::peridynamics
