#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solid/peridynamics/solvers/two_level.hpp"
#include "solid/peridynamics/watch.hpp"

namespace arenite::peridynamics {

/// How a static solve ended.
struct StaticReport {
  bool converged = false;
  bool stopped = false;  ///< the watch asked for it
  int iterations = 0;
  double residual = 0;          ///< relative, of the field that is handed back, worked out anew
  std::vector<double> history;  ///< relative residual after each iteration, the start first
  std::int32_t coarse_unknowns = 0;
  int repairs = 0;              ///< CoarseSpace::repairs
  std::size_t loose_nodes = 0;  ///< nodes that can move freely in some direction
};

/// Linearised equilibrium by conjugate gradients with the two-level preconditioner. The object keeps its set-up for
/// many right sides, and through broken bonds: the preconditioner may lag behind the bonds.
class StaticSolver {
 public:
  /// `pieces` are those that carry (support.hpp), `prescribed` has one entry a row.
  StaticSolver(const Bonds& bonds, Pieces pieces, std::vector<std::uint8_t> prescribed);
  ~StaticSolver();

  /// On entry `u` holds the prescribed displacements and a first guess, on return the field at equilibrium. Residuals
  /// are relative to that of uniform strain (reference.hpp).
  /// `body`, if given, is a force on every node beside that of the bonds.
  StaticReport solve(const Bonds& bonds, Field<double>& u, double tolerance, int max_iterations,
                     const Watch& watch = {}, const Field<double>* body = nullptr);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace arenite::peridynamics
