#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/field_result.hpp"
#include "solid/peridynamics/pull_state.hpp"
#include "solid/peridynamics/watch.hpp"
#include "recipe/recipe.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/run.hpp"
#include "workflow/stage_keys.hpp"

/// The second half of a run: cement, raster, loads (P II.B to IV).
namespace arenite::study {

/// Materials of the large and of the small grains: those of [bidisperse], or of two materials the one with the larger mean
/// radius; nothing where a packing has no two classes.
struct ClassMaterials {
  std::int32_t large = 0, small = 1;
};
std::optional<ClassMaterials> class_materials(const Recipe& recipe, const Packing& packing);

/// The class of every grain by its material; empty without classes.
std::vector<GrainClass> classes(const Packing& packing, const std::optional<ClassMaterials>& materials);

/// The radius that gaps and crops are measured by: large_radius of [bidisperse], or the mean radius of the large grains,
/// or of all, m.
double reference_radius(const Recipe& recipe, const Packing& packing);

/// Cements and rasterises a packing, with its phases, pores, voids and coordination as numbers. Throws InputError for a
/// saturation out of reach and a crop wider than the sample.
FieldResult make_cemented_sample(const Recipe& recipe, const Packing& packing);

/// How a pull to failure is kept on its way and where it goes on from; other loads take no notice.
struct PullCheckpoint {
  peridynamics::KeepPull keep{};
  std::optional<peridynamics::PullState> resume{};
};

/// Loads a cemented sample. An unfinished field has `converged` false and says why; nothing if the watch stopped it.
std::optional<FieldResult> apply_load(const Load& load, const FieldResult& sample, const peridynamics::Watch& watch,
                                      const PullCheckpoint& checkpoint = {});

/// Does, or reads from the store, the cemented sample and all loads; appends to `outcome`.
void run_fields(const Recipe& recipe, const std::vector<PlannedStage>& plan, const ResultFolder& folder, const RunOptions& options,
                Progress progress, RunOutcome& outcome);

}  // namespace arenite::study
