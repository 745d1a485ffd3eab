#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solid/peridynamics/aggregates.hpp"
#include "solid/peridynamics/load.hpp"

namespace arenite::peridynamics {

/// Linearised equilibrium by conjugate gradients with the two-level preconditioner. The object keeps its set-up for
/// many right sides, and through broken bonds: the preconditioner may lag behind the bonds.
class StaticSolver {
 public:
  /// `aggregates` are those that carry (support.hpp), `prescribed` has one entry a row.
  StaticSolver(const Bonds& bonds, Aggregates aggregates, std::vector<std::uint8_t> prescribed);
  ~StaticSolver();

  /// On entry `u` holds the prescribed displacements and a first guess, on return the field at equilibrium. Residuals
  /// are relative to that of uniform strain (residual_reference). `body`, if given, is a force on every node beside
  /// that of the bonds.
  StaticReport solve(const Bonds& bonds, Field<double>& u, double tolerance, int max_iterations,
                     const Watch& watch = {}, const Field<double>* body = nullptr);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Equilibrium under P's stretch: the linearised solve, again and again, with what it leaves out as a body force. The
/// error falls by about the strain in each round. Forces that turn a loose node about its hinge are left out: linearly
/// nothing resists them. Ends with the best field found where rounds stop helping.
StaticReport solve_exact_stretch(const Bonds& bonds, double dx, const std::vector<std::uint8_t>& prescribed,
                                 StaticSolver& solver, Field<double>& u, double tolerance, int max_iterations,
                                 const Watch& watch = {});

}  // namespace arenite::peridynamics
