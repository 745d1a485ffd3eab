#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/result.hpp"
#include "model/voxel_map.hpp"
#include "recipe/recipe.hpp"
#include "solid/statics/watch.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

/// Whether a map is a sample in space: its key says so, or its file holds nothing but volumes.
bool is_in_space(const recipe::MapSection& map);

/// A voxel map of a file, its grains labelled; what is found worth a word is told.
VoxelMap read_voxels(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice);

/// Loads a sample in space between its lowest and its highest layer by elements; with `load.effective_stiffness` that
/// follows, as of a sample that repeats itself. Nothing if the watch stopped it. Throws InputError for keys that are of
/// the plane.
std::optional<VoxelResult> apply_load(const recipe::Load& load, const VoxelMap& map, const statics::Watch& watch);

struct VoxelOutcome {
  std::optional<VoxelResult> result;  ///< nothing if it was stopped
  std::filesystem::path file;         ///< empty where nothing is stored
};

/// The same of a file; the result is one file in `options.out`, taken from there if it was computed before. Throws
/// InputError for what cannot be read as a voxel map.
VoxelOutcome load_voxels(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options);

}  // namespace arenite::workflow
