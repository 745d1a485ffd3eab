#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grains/texture/texture.hpp"
#include "model/film_result.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::report {

/// The texture of one stored state.
struct FrameTexture {
  std::size_t stage = 0, frame = 0;  ///< positions in the list of stages and in its frames
  texture::Texture texture;
};

/// A cemented sample or its stresses under load. The densities of the node stresses are measured for the page by
/// `statistics`: those of the load make them agree with its numbers. All components are shown, whichever it names.
struct FieldPageData {
  const FieldResult* result = nullptr;
  stress::StressOptions statistics{};
};

/// What a film of a loaded packing gave. `options` say which grains count in the statistics of grain stresses, which are
/// measured for the page, of the film and of its companion simulation alike.
struct FilmPageData {
  const FilmResult* result = nullptr;
  texture::Options options{};
};

/// What the page shows: the stages of one run in their order, and the texture of some of their states. The figures show
/// the texture of the state that the slider is on, or else that of the last state that has one. Results on a grid
/// follow, then films, each on a tab of its own; any of the three may be missing.
struct PageData {
  std::string title;
  std::vector<const StageResult*> stages;
  std::vector<FrameTexture> textures;
  std::vector<FieldPageData> fields{};
  std::vector<FilmPageData> films{};
};

/// What a result holds, wherever it comes from: a run that has just ended, a folder, parts put together.
struct ResultParts {
  std::string title;
  std::span<const StageResult> stages{};
  std::span<const FieldResult> fields{};
  std::span<const FilmResult> films{};
  std::span<const std::optional<texture::Texture>> measured{};  ///< of the last state of each stage, where it is known already (workflow::RunOutcome)
};

/// Writes the page of a result, all or nothing. What it shows follows from the result alone: textures are measured as each
/// stage's own recipe says, of all states of a small sample and of the last one of each stage of a large one; densities of
/// stresses as the load's numbers were; and the grains of a film with their forces are a stage before the others. Throws
/// InputError when the system refuses.
void write_page(const std::filesystem::path& path, const ResultParts& result);

/// The page of these files of stages, fields and films. Throws InputError for a file that cannot be read.
void write_page(const std::filesystem::path& path, const std::vector<std::filesystem::path>& files, const std::string& title);

/// The page as one HTML text: script, styles and data inside, no request to anywhere. States whose number of grains
/// differs from the last one's are left out.
std::string page(const PageData& data);

/// Writes the page, all or nothing. Throws InputError when the system refuses.
void write_page(const std::filesystem::path& path, const PageData& data);

}  // namespace arenite::report
