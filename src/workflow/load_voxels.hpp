#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/result.hpp"
#include "model/voxel_map.hpp"
#include "recipe/recipe.hpp"
#include "solid/elements/load.hpp"
#include "solid/statics/watch.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {

/// Whether a map is a sample in space: its key says so, or its file holds nothing but volumes.
bool is_in_space(const recipe::MapSection& map);

/// Throws InputError for keys of a load that are of the plane, and for what another solver than the program's own
/// cannot do.
void require_space(const recipe::Load& load, const elements::OtherSolver* solver = nullptr);

/// A voxel map of a file, its grains labelled; what is found worth a word is told.
VoxelMap read_voxels(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice);

/// Loads a sample in space between its lowest and its highest layer by bonds or elements; with
/// `load.effective_stiffness` that follows, as of a sample that repeats itself; with `load.failure` until it breaks.
/// `threads` work on elements. Nothing if the watch stopped it. Throws InputError as require_space does.
std::optional<VoxelResult> apply_load(const recipe::Load& load, const VoxelMap& map, const statics::Watch& watch,
                                      const elements::OtherSolver* solver = nullptr,
                                      const FailureCheckpointIn<3>& checkpoint = {}, int threads = Threads{}.threads);

/// The same of a file, kept as load_by_itself says. Throws InputError for what cannot be read as a voxel map.
LoadedMap<VoxelResult> load_voxels(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options,
                                   const elements::OtherSolver* solver = nullptr);

}  // namespace arenite::workflow
