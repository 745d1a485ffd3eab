#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace arenite::workflow {

/// By which program stages of grains are run, and how.
struct EngineOptions {
  enum class Engine { arenite, lammps };
  Engine engine = Engine::arenite;
  std::vector<std::string> stages;  ///< that LAMMPS runs; all, if empty
  int ranks = 2;
  std::string command;  ///< that starts LAMMPS; empty: mpirun with `ranks`
  std::int64_t restart_every = 10000;
  bool prepare = false;

  bool is_lammps() const { return engine == Engine::lammps; }
  /// Whether LAMMPS runs the stage of that name.
  bool carries(const std::string& stage) const;
  /// The line that starts LAMMPS.
  std::string line() const;
};
void declare(ParameterVisitor& visitor, EngineOptions& options);

}  // namespace arenite::workflow
