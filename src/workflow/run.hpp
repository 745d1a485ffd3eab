#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/thread_count.hpp"
#include "grains/texture/texture.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"
#include "recipe/recipe.hpp"
#include "solid/stress/stress.hpp"
#include "workflow/checkpoints.hpp"
#include "workflow/grain_stage.hpp"

namespace arenite::dem {
template <int D> class EngineIn;
using Engine = EngineIn<2>;
}  // namespace arenite::dem

namespace arenite::workflow {

/// Where a side is while a stage is under way, and what presses on it.
struct SideNow {
  bool present = false;
  double position = 0, force = 0;  ///< m, N
};

/// Where a run stands, for a bar or a log.
struct Progress {
  std::size_t stage = 0, stages = 0;  ///< 0 is the packing
  std::string name;                   ///< of the stage
  double share = 0;                   ///< of the stage, 0 to 1; of one that does not settle, what came to rest so far
  double unbalanced_ratio = 0;        ///< of grains
  double residual = 0;                ///< of a field, relative
  std::int64_t step = 0;
  bool reused = false;                         ///< the stage's file was there already
  bool field = false;                          ///< of nodes: `step` counts iterations
  std::string key{};                           ///< hash of the stage, which its checkpoint carries
  std::int64_t increment = 0, increments = 0;  ///< the one under way, from 1; 0 where the stage has none
  double time = 0;                             ///< of the sample, s
  ByAnySide<SideNow> side{};                   ///< now; none is present where `time` is none
  bool settles = true;                         ///< as fast as predicted, within ten times
};

class Store;
struct EngineOptions;
struct StepFunction;

struct RunOptions {
  std::filesystem::path out;
  std::function<void(const Progress&)> progress = [](const Progress&) {};
  std::function<void(const std::string&)> notice = [](const std::string&) {};  ///< a sentence the user should see
  std::function<bool()> asked_to_stop = [] { return false; };                  ///< true: checkpoint and leave
  double checkpoint_seconds = Checkpoints{}.every;                             ///< between two checkpoints
  int threads = Threads{}.threads;  ///< that work on the voxels of load_voxels()
  const Store* store = nullptr;     ///< stages that are there are taken from it, and what is computed is put there
  bool page_follows = false;        ///< of stresses, what a page alone shows is measured with the rest
  const StepFunction* on_step = nullptr;  ///< called while a stage of loading is computed (stage_watch.hpp)
  const EngineOptions* engine = nullptr;  ///< another program that runs stages (lammps/engine_options.hpp)
};

/// What a run measured of its results, in their order, for the page to take over; nothing where a result was there
/// already.
struct KnownStatistics {
  std::vector<std::optional<texture::Texture>>
      stages{};  ///< of the last state of each, as fields::texture_options asks
  std::vector<std::optional<stress::Statistics>> fields{};  ///< of all components; only where a page follows
  std::vector<std::optional<texture::Texture>> films{};     ///< texture_of
};

struct RunOutcome {
  bool converged = true;
  bool interrupted = false;                  ///< asked to stop; the next run goes on from the checkpoint
  std::vector<std::filesystem::path> files;  ///< one a stage, in order
  std::vector<StageResult> stages;
  std::vector<SphereResult> spheres;  ///< stages of a recipe in space
  std::vector<FieldResult> fields;    ///< the cemented sample and its loads, after the stages
  std::vector<VoxelResult> voxels;    ///< loads of a sample in space
  KnownStatistics measured;
};

/// Runs a recipe: packing, then its stages one after the other; every stage ends as one file in `options.out`, named by
/// the hash of all that it depends on. A stage whose file is there is read, not computed again; a run that was killed
/// goes on from its last checkpoint and ends with the same bytes. Of runs that share a store and want the same stage at
/// once, one computes it and the others wait. A damaged file counts as none, with a notice. A stage that finds no
/// equilibrium ends the run; loads of the cemented sample are independent of each other, and the next is tried.
/// A stage that `on_step` has changed has a hash of its own, and so has all that comes after it: such files are no
/// results of the recipe alone, which computes them again, and no store gets them. Stages with it are not resumed on
/// their way.
[[nodiscard]] RunOutcome run(const recipe::Recipe& recipe, const RunOptions& options);

/// Takes the grains of an engine through a stage of loading and measures it. It is kept in the file `checkpoint` on its
/// way, unless that is empty, and goes on from there; nothing if it was asked to stop. A result that `on_step`
/// (stage_watch.hpp) has changed names the changes, and has a hash of its own.
template <int D>
std::optional<StageResultIn<D>> load_stage(const GrainStageIn<D>& stage, dem::EngineIn<D>& engine,
                                           const std::filesystem::path& checkpoint, const RunOptions& options,
                                           const Progress& progress, const StepFunction* on_step = nullptr);

}  // namespace arenite::workflow
