#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/kernels/kernels.hpp"
#include "solid/peridynamics/load.hpp"
#include "solid/statics/static_solver.hpp"

namespace arenite::peridynamics {

using StaticSolver = statics::StaticSolver<Bonds>;

/// f := force of the bonds on every node, clamped ones too; returns sum u . f.
double linear_force(const Bonds& bonds, const Field<double>& u, Field<double>& f);

/// Equilibrium under P's stretch: the linearised solve, again and again, with what it leaves out as a body force. The
/// error falls by about the strain in each round. Forces that turn a loose node about its hinge, and those along
/// motions that nothing resists linearly, are left out. Ends with the best field found where rounds stop helping.
StaticReport solve_exact_stretch(const Bonds& bonds, double dx, const std::vector<std::uint8_t>& prescribed,
                                 StaticSolver& solver, Field<double>& u, double tolerance, int max_iterations,
                                 const Watch& watch = {});

}  // namespace arenite::peridynamics
