#include "equilibrium.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "galerkin.hpp"
#include "slab.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/statics/residual.hpp"

namespace arenite::cluster {
namespace {

Slab& slab_of(Mat shell) {
  void* context = nullptr;
  must(MatShellGetContext(shell, &context));
  return *static_cast<Slab*>(context);
}

PetscErrorCode apply_stiffness(Mat shell, ::Vec u, ::Vec to) {
  slab_of(shell).stiffness(u, to);
  return 0;
}

PetscErrorCode apply_inverse_diagonal(PC pc, ::Vec r, ::Vec to) {
  void* context = nullptr;
  must(PCShellGetContext(pc, &context));
  static_cast<const Slab*>(context)->unsmoothed(r, to);
  return 0;
}

/// From the coarse mesh to the fine one; nothing moves what is held.
struct Hats {
  const Slab* slab;
  Matrix plain;
};

PetscErrorCode interpolate(Mat shell, ::Vec coarse, ::Vec fine) {
  void* context = nullptr;
  must(MatShellGetContext(shell, &context));
  const Hats& hats = *static_cast<const Hats*>(context);
  must(MatMult(hats.plain, coarse, fine));
  hats.slab->keep_free(fine);
  return 0;
}

PetscErrorCode restrict_down(Mat shell, ::Vec fine, ::Vec coarse) {  // residuals are nothing where it is held
  void* context = nullptr;
  must(MatShellGetContext(shell, &context));
  must(MatMultTranspose(static_cast<const Hats*>(context)->plain, fine, coarse));
  return 0;
}

using Operation = void (*)(void);
template <class F> void set_operation(Mat shell, MatOperation what, F function) {
  must(MatShellSetOperation(shell, what, reinterpret_cast<Operation>(function)));
}

Matrix shell_of(PetscInt rows, PetscInt columns, void* context) {
  Matrix shell;
  must(MatCreateShell(PETSC_COMM_WORLD, rows, columns, PETSC_DETERMINE, PETSC_DETERMINE, context, &shell));
  return shell;
}

PetscInt local_size(DM mesh) {
  Vector v;
  PetscInt size = 0;
  must(DMCreateGlobalVector(mesh, &v));
  must(VecGetLocalSize(v, &size));
  return size;
}

/// How far the solve is; the first rank's watch is asked, for all.
struct Course {
  const Problem& problem;
  std::function<bool(int iterations, double residual)> goes_on;
  std::vector<double> history{};
  bool stopped = false;
};

PetscErrorCode judge_course(KSP, PetscInt iterations, PetscReal norm, KSPConvergedReason* reason, void* context) {
  Course& course = *static_cast<Course*>(context);
  const double residual = norm / course.problem.reference;
  course.history.push_back(residual);
  *reason = KSP_CONVERGED_ITERATING;
  if (!std::isfinite(residual)) *reason = KSP_DIVERGED_NANORINF;
  else if (residual <= course.problem.tolerance) *reason = KSP_CONVERGED_ATOL;
  else if (iterations >= course.problem.max_iterations) *reason = KSP_DIVERGED_ITS;
  else if (!told(course.goes_on(static_cast<int>(iterations), residual)))
    course.stopped = true, *reason = KSP_DIVERGED_BREAKDOWN;
  return 0;
}

/// Two levels: Chebyshev steps of our own rows on the voxels, and on the coarse mesh algebraic multigrid.
void set_multigrid(PC pc, Slab& slab, Mat hats, Mat coarse) {
  must(PCSetType(pc, PCMG));
  must(PCMGSetLevels(pc, 2, nullptr));
  must(PCMGSetInterpolation(pc, 1, hats));
  KSP smoother = nullptr, below = nullptr;
  PC inner = nullptr;
  must(PCMGGetSmoother(pc, 1, &smoother));
  const auto [degree, lowest, highest] = elements::smoothing_of(slab.voxels);
  must(KSPSetType(smoother, KSPCHEBYSHEV));
  must(KSPChebyshevSetEigenvalues(smoother, highest, lowest));
  must(KSPSetTolerances(smoother, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, degree));
  must(KSPSetNormType(smoother, KSP_NORM_NONE));
  must(KSPSetConvergenceTest(smoother, KSPConvergedSkip, nullptr, nullptr));
  must(KSPGetPC(smoother, &inner));
  must(PCSetType(inner, PCSHELL));
  must(PCShellSetContext(inner, &slab));
  must(PCShellSetApply(inner, apply_inverse_diagonal));
  must(PCMGGetCoarseSolve(pc, &below));
  must(KSPSetOperators(below, coarse, coarse));
  must(KSPSetType(below, KSPPREONLY));
  must(KSPGetPC(below, &inner));
  must(PCSetType(inner, PCGAMG));
  std::array<PetscReal, 1> no_zeros{0};  // what nothing joins is no neighbour
  must(PCGAMGSetThreshold(inner, no_zeros.data(), 1));
}

statics::StaticReport solve_together(const Problem& problem, Slab& slab, ::Vec u, Course& course) {
  Vector right, added;
  must(VecDuplicate(u, &right));
  must(VecDuplicate(u, &added));
  slab.stiffness(u, right);
  must(VecScale(right, -1));
  const PetscInt fine = local_size(slab.fine), rough = local_size(slab.coarse);
  const Matrix stiffness = shell_of(fine, fine, &slab);
  set_operation(stiffness, MATOP_MULT, apply_stiffness);
  Hats hats{&slab, {}};
  must(DMCreateInterpolation(slab.coarse, slab.fine, &hats.plain, nullptr));
  const Matrix to_fine = shell_of(fine, rough, &hats);
  set_operation(to_fine, MATOP_MULT, interpolate);
  set_operation(to_fine, MATOP_MULT_TRANSPOSE, restrict_down);
  const Matrix coarse = coarse_stiffness(slab);

  Solver solver;
  PC pc = nullptr;
  must(KSPCreate(PETSC_COMM_WORLD, &solver));
  must(KSPSetType(solver, KSPCG));
  must(KSPSetOperators(solver, stiffness, stiffness));
  must(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED));
  must(KSPSetTolerances(solver, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, problem.max_iterations + 1));
  must(KSPSetConvergenceTest(solver, judge_course, &course, nullptr));
  must(KSPGetPC(solver, &pc));
  set_multigrid(pc, slab, to_fine, coarse);
  must(KSPSetFromOptions(solver));
  must(KSPSolve(solver, right, added));
  must(VecAXPY(u, 1, added));

  statics::StaticReport report;
  PetscInt iterations = 0;
  must(KSPGetIterationNumber(solver, &iterations));
  report.iterations = static_cast<int>(iterations);
  slab.stiffness(u, right);  // worked out anew
  double norm = 0;
  must(VecNorm(right, NORM_2, &norm));
  report.residual = norm / problem.reference;
  report.stopped = course.stopped;
  report.converged = !report.stopped && report.residual <= 1.01 * problem.tolerance;
  return report;
}

/// What all ranks do at one sample; the first one has it.
struct Whole {
  const elements::Voxels* elements = nullptr;
  statics::FieldIn<3, double>* u = nullptr;
  const statics::Watch* watch = nullptr;
};

statics::StaticReport take_part(const Problem& problem, std::vector<std::uint8_t> prescribed, const Whole& whole) {
  prescribed.resize(static_cast<std::size_t>(problem.cells[2]) + 1);
  tell_bytes(prescribed.data(), prescribed.size());
  Slab slab(problem, prescribed, whole.elements);
  const statics::Grid grid(problem.cells[0] + 1, problem.cells[1] + 1, problem.cells[2] + 1);
  statics::FieldIn<3, double> none;
  statics::FieldIn<3, double>& field = whole.u ? *whole.u : none;
  Vector u;
  must(DMCreateGlobalVector(slab.fine, &u));
  slab.hand_out(field, grid, u);
  const statics::Watch nobody;
  statics::Reporter reporter(whole.watch ? *whole.watch : nobody, problem.tolerance);
  Course course{problem, [&](int n, double residual) { return reporter.goes_on(n, residual); }};
  statics::StaticReport report = solve_together(problem, slab, u, course);
  report.history = std::move(course.history);
  slab.hand_in(u, grid, field);
  return report;
}

statics::StaticReport solve(const elements::Voxels& elements, const std::vector<std::uint8_t>& prescribed,
                            statics::FieldIn<3, double>& u, double tolerance, int max_iterations,
                            const statics::Watch& watch) {
  Problem problem{elements.cells, elements.modes, elements.table, tolerance, 0, max_iterations};
  {
    statics::FieldIn<3, double> work(elements.grid.padded_size()), force(elements.grid.padded_size());
    problem.reference = statics::residual_reference(elements, prescribed, u, work, force);
  }
  if (!(problem.reference > 0)) {
    statics::StaticReport report;
    report.converged = std::isfinite(problem.reference);
    return report;
  }
  try {
    return take_part(told(problem), prescribed, {&elements, &u, &watch});
  } catch (const std::exception& error) {  // the others wait for what will not come
    std::fprintf(stderr, "arenite load: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
    throw;
  }
}

}  // namespace

elements::OtherSolver petsc_solver() {
  const std::string version = std::to_string(PETSC_VERSION_MAJOR) + "." + std::to_string(PETSC_VERSION_MINOR) + "." +
                              std::to_string(PETSC_VERSION_SUBMINOR);
  const int ranks = rank_count();
  return {"PETSc " + version + " on " + std::to_string(ranks) + (ranks == 1 ? " process" : " processes"), solve};
}

void help_out() {
  for (Problem problem; (problem = told(Problem{})).cells[0] > 0;) take_part(problem, {}, {});
}

void dismiss_the_others() { told(Problem{}); }

}  // namespace arenite::cluster
