// arenite-petsc: `arenite load` of samples in space by elements, solved on many machines under mpirun.
#include <petscsys.h>

#include <cstdio>
#include <exception>
#include <vector>

#include "commands.hpp"
#include "equilibrium.hpp"
#include "program.hpp"
#include "ranks.hpp"

using namespace arenite;

// Three loads times 2^31 nodes and more.
static_assert(sizeof(PetscInt) == 8, "PETSc counts in 32 bits here; take one made with --with-64-bit-indices");

namespace {

const elements::OtherSolver& solver() {
  static const elements::OtherSolver one = cluster::petsc_solver();
  return one;
}

int work(int argc, char** argv) {
  if (cluster::own_rank() == cluster::first_rank) {
    const int status = app::run_program(argc, argv);
    cluster::dismiss_the_others();
    return status;
  }
  try {
    cluster::help_out();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "arenite load: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return 0;
}

}  // namespace

const std::vector<app::Command>& app::commands() {
  static const std::vector<Command> list{
      {"load", "Load a phase map in space by elements, on all processes of mpirun",
       [](Options& command, int& status) { add_load_by(&solver(), command, status); }}};
  return list;
}

int main(int argc, char** argv) {
  app::start_anew_with({app::one_blas_thread}, argv);  // those of a process would share its core
  int none = 0;  // the command line is ours; PETSc's options come from PETSC_OPTIONS
  if (PetscInitialize(&none, nullptr, nullptr, nullptr)) return app::other_failure;
  const int status = work(argc, argv);
  PetscFinalize();
  return status;
}
