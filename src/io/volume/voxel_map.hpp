#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/image/phase_map.hpp"
#include "io/volume/volume.hpp"
#include "model/voxel_map.hpp"

namespace arenite::io {

/// How a volume is a voxel map.
struct VoxelMapOptions {
  VolumeChoice volume;
  PhaseTable phases;                            ///< empty: guessed of a volume of two values, the higher is particle
  std::optional<double> dx;                     ///< side of a voxel, m; not given: what the file states, or 1
  std::optional<std::filesystem::path> labels;  ///< volume whose values number the grains, 0 where there is none
  VolumeChoice label_volume;
};

/// A voxel map from a volume.
struct ForeignVoxels {
  VoxelMap map;  ///< without labels: `grain` is -1 everywhere and `grain_class` empty, to be labelled
  bool labelled = false;
  std::vector<std::string> notes;
};

/// Throws InputError for what open_volume refuses, values that the table lacks, more than two values without a table,
/// labels of another size, labels where no particle is, and particles without label.
ForeignVoxels read_voxel_map(const std::filesystem::path& path, const VoxelMapOptions& options);

}  // namespace arenite::io
