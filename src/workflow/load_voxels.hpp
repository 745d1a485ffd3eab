#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/voxel_map.hpp"
#include "recipe/recipe.hpp"
#include "solid/statics/watch.hpp"
#include "statistics/numbers.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

/// Whether a map is a sample in space: its key says so, or its file holds nothing but volumes.
bool is_in_space(const recipe::MapSection& map);

/// A voxel map of a file, its grains labelled; what is found worth a word is told.
VoxelMap read_voxels(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice);

/// A sample in space under load.
struct VoxelResult {
  bool converged = false;
  std::string outcome;  ///< how it ended
  VoxelStress field;
  Numbers numbers;  ///< of the sample, the load and its stresses
};

/// Loads a sample in space between its lowest and its highest layer by elements; with `load.effective_stiffness` that
/// follows, as of a sample that repeats itself. Nothing if the watch stopped it. Throws InputError for keys that are of
/// the plane.
std::optional<VoxelResult> apply_load(const recipe::Load& load, const VoxelMap& map, const statics::Watch& watch);

struct VoxelOutcome {
  std::optional<VoxelResult> result;  ///< nothing if it was stopped
  std::filesystem::path field, file;  ///< the field (.vti) and the numbers (.json); empty where nothing is stored
};

/// The same of a file, its field and its numbers in the folder `options.out`. Throws InputError for what cannot be read
/// as a voxel map.
VoxelOutcome load_voxels(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options);

}  // namespace arenite::workflow
