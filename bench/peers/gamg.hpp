#pragma once
#include <petscksp.h>

#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../process_use.hpp"

/// Conjugate gradients of PETSc with algebraic multigrid (GAMG) and the rigid modes as near null space, on rows that a
/// peer assembled.
namespace arenite::bench {

inline void must(PetscErrorCode code) {
  if (code) throw std::runtime_error("PETSc failed");
}

/// Rows of the free nodes in compressed form, their components one after the other. `u` is what the solve begins with
/// and its result; `place` has as many numbers, in any unit of length.
struct Rows {
  PetscInt components = 0;
  std::vector<PetscInt> begin{0}, column = {};
  std::vector<double> value = {}, right = {}, u = {}, place = {};
};

struct Ending {
  double relative_residual = 1e-6;
  std::optional<double> reference = {};  ///< of residuals; if not given that of `u` as it was handed over
  PetscInt most_iterations = 2000;
};

struct GamgOutcome {
  double assembly = 0, setup = 0, solve = 0, residual = 0;  ///< CPU seconds; over the reference
  PetscInt iterations = 0;
};

/// The time of assembly is counted from `began` (cpu_seconds).
inline GamgOutcome solve_by_gamg(Rows& rows, const Ending& ending, double began) {
  GamgOutcome out;
  const auto n = static_cast<PetscInt>(rows.right.size());
  Mat a;
  must(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, rows.begin.data(), rows.column.data(), rows.value.data(), &a));
  must(MatSetBlockSize(a, rows.components));
  must(MatSetOption(a, MAT_SPD, PETSC_TRUE));
  ::Vec place, right, u, left;
  for (const auto& [vector, values] : {std::pair{&place, &rows.place}, {&right, &rows.right}, {&u, &rows.u}})
    must(VecCreateSeqWithArray(PETSC_COMM_SELF, rows.components, n, values->data(), vector));
  MatNullSpace rigid;
  must(MatNullSpaceCreateRigidBody(place, &rigid));
  must(MatSetNearNullSpace(a, rigid));
  must(VecDuplicate(right, &left));
  must(MatMult(a, u, left));
  must(VecAYPX(left, -1, right));
  double reference = 0;
  must(VecNorm(left, NORM_2, &reference));
  reference = ending.reference.value_or(reference);
  out.assembly = cpu_seconds() - began;

  KSP solver;
  PC multigrid;
  must(KSPCreate(PETSC_COMM_SELF, &solver));
  must(KSPSetType(solver, KSPCG));
  must(KSPSetOperators(solver, a, a));
  must(KSPSetInitialGuessNonzero(solver, PETSC_TRUE));
  must(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
  must(KSPSetTolerances(solver, 1e-50, ending.relative_residual * reference, PETSC_DEFAULT, ending.most_iterations));
  must(KSPGetPC(solver, &multigrid));
  must(PCSetType(multigrid, PCGAMG));
  must(KSPSetFromOptions(solver));
  must(KSPSetUp(solver));
  out.setup = cpu_seconds() - began - out.assembly;
  must(KSPSolve(solver, right, u));
  out.solve = cpu_seconds() - began - out.assembly - out.setup;
  must(KSPGetIterationNumber(solver, &out.iterations));
  must(KSPGetResidualNorm(solver, &out.residual));
  out.residual /= reference;
  must(KSPDestroy(&solver));
  must(MatDestroy(&a));
  must(MatNullSpaceDestroy(&rigid));
  for (::Vec* vector : {&place, &right, &u, &left}) must(VecDestroy(vector));
  return out;
}

}  // namespace arenite::bench
