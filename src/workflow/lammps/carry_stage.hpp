#pragma once
#include <string>
#include <vector>

#include "grains/dem/run_stage.hpp"
#include "recipe/recipe.hpp"
#include "workflow/lammps/engine_options.hpp"
#include "workflow/run.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::workflow {

/// Throws InputError, every sentence in one pass, where stages that LAMMPS is to run ask for what it cannot express, or
/// where a stage is named that the recipe does not have.
template <int D>
void require_lammps(const recipe::Recipe& recipe, const PackingIn<D>& start, const EngineOptions& options);

/// The plan of a run; with other hashes from the first stage on that LAMMPS runs, for its results are not those of the
/// recipe alone. Throws InputError where LAMMPS is to run with a function that looks at every step.
std::vector<PlannedStage> plan_of(const recipe::Recipe& recipe, const RunOptions& options);

/// How LAMMPS had its part in a stage.
enum class Part {
  none,     ///< it has none: the stage runs here, from its beginning on
  carried,  ///< it carried the sample, and the stage goes on here to its end
  stopped   ///< the run was asked to stop, or the files are for somebody else to run
};

/// Lets LAMMPS carry the sample of a stage that has just begun through its first leg: to rest as far as LAMMPS judges
/// it, or for its time. The state comes back into the engine with all forces computed anew; how they agree is told, and
/// stands in the folder of LAMMPS's files.
template <int D>
Part carry_by_lammps(const GrainStageIn<D>& stage, dem::EngineIn<D>& engine, dem::StageRunIn<D>& run,
                     const RunOptions& options, const Progress& progress);

/// A result that says LAMMPS's part in its stage, of that hash, in its outcome and options, if it had one.
template <int D>
StageResultIn<D> tell_of_lammps(StageResultIn<D> made, const RunOptions& options, const std::string& hash);

}  // namespace arenite::workflow
