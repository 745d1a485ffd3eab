#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/film_result.hpp"

namespace arenite::workflow {
struct KnownStatistics;
}

namespace arenite::report {

/// What a result holds, wherever it comes from: a run that has just ended, a folder, parts put together. Any part may
/// be missing. The page shows the stages in their order; results on a grid follow, then films, then samples in space,
/// each on a tab of its own.
struct PageData {
  std::string title{};  ///< if empty, title_of
  std::span<const StageResult> stages{};
  std::span<const FieldResult> fields{};
  std::span<const FilmResult> films{};
  std::span<const VoxelResult> voxels{};
  std::span<const SphereResult> spheres{};
  const workflow::KnownStatistics* measured = nullptr;  ///< what the run measured of these already; unset: nothing
};

/// Title of the recipe that a result was made by; of a recipe without one the name of the film, and of a loaded phase
/// map "tension of map.png".
std::string title_of(const PageData& data);

/// The page as one HTML text: script, styles and data inside, no request to anywhere. What it shows follows from the
/// result alone: textures are measured as each stage's own recipe says, of all states of a small sample and of the last
/// one of each stage of a large one; densities of stresses as the load's numbers were; and the grains of a film with
/// their forces are a stage before the others. The figures show the texture of the state that the slider is on, or else
/// that of the last state that has one. States whose number of grains differs from the last one's are left out.
std::string page(const PageData& data);

/// Writes the page, all or nothing. Throws InputError when the system refuses.
void write_page(const std::filesystem::path& path, const PageData& data);

/// The page of these files of stages, fields and films. Throws InputError for a file that cannot be read.
void write_page(const std::filesystem::path& path, const std::vector<std::filesystem::path>& files,
                const std::string& title);

}  // namespace arenite::report
