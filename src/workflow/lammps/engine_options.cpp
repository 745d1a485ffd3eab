#include "workflow/lammps/engine_options.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace arenite::workflow {

bool EngineOptions::carries(const std::string& stage) const {
  return is_lammps() && (stages.empty() || std::ranges::count(stages, stage) > 0);
}

std::string EngineOptions::line() const {
  if (!command.empty()) return command;
  return ranks == 1 ? "lmp" : fmt::format("mpirun -np {} lmp", ranks);
}

void declare(ParameterVisitor& v, EngineOptions& options) {
  v.choice({"engine", "Program that runs the stages of grains; the forces of results are always Arenite's."},
           options.engine,
           {{"arenite", "itself"},
            {"lammps", "LAMMPS, on any number of processes, as far as it can express a stage (docs/lammps.md)"}});
  v.texts({"lammps_stages", "Stages that LAMMPS runs; all if not given."}, options.stages);
  v.integer({"ranks", "Processes of LAMMPS, by MPI."}, options.ranks, {1, 1'000'000});
  v.text({"lammps_command", "Command that starts LAMMPS, without its arguments; mpirun and lmp if not given."},
         options.command);
  v.integer({"restart_every", "Steps between two restart files of LAMMPS."}, options.restart_every, {1, 1'000'000'000});
  v.flag({"prepare", "Write LAMMPS's files and end, for a cluster that runs them."}, options.prepare);
}

}  // namespace arenite::workflow
