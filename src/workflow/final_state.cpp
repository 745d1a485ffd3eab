#include "workflow/final_state.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "io/stage_file.hpp"
#include "recipe/recipe.hpp"
#include "workflow/run.hpp"

namespace arenite::study {

namespace {

namespace fs = std::filesystem;

/// The last file of a stage of loading, or that of the stage of this name.
fs::path file_of(const fs::path& run, const std::string& stage) {
  auto files = io::stage_files(run);
  std::erase_if(files, [&](const fs::path& file) { return io::sealed_kind(file) != "result" || (!stage.empty() && io::read_stage(file).name != stage); });
  if (!files.empty()) return files.back();
  if (stage.empty()) throw InputError(run.string(), 0, "there are no stage files of this run; remove its folder and run the study again");
  throw InputError(run.string(), 0, fmt::format("there is no stage \"{}\" of this run; name one of its recipe, or run the study again", stage));
}

/// As the recipe asks; the packing, which is the first file, knows of no loading.
texture::Options options_of(const Provenance& provenance, const fs::path& file, const fs::path& run) {
  if (file == io::stage_files(run).front()) return {};
  const Recipe recipe = parse_recipe(provenance.recipe, file.string());
  return texture_options(recipe, recipe.stages.size());
}

struct Measurable {
  Packing packing;
  texture::Options options;
};

Measurable last_packing(const fs::path& run, const std::string& stage) {
  const fs::path file = file_of(run, stage);
  StageResult result = io::read_stage(file);
  if (result.frames.empty()) throw InputError(file.string(), 0, "this stage holds no state; remove it and run the study again");
  return {std::move(result.frames.back().packing), options_of(result.provenance, file, run)};
}

}  // namespace

FinalState final_state(const fs::path& run, bool rev, const std::string& stage, int sectors) {
  auto [packing, options] = last_packing(run, stage);
  if (!rev) options.rev_sizes = 0;
  options.sectors = sectors;
  texture::Texture texture = texture::measure(packing, options);
  return {std::move(packing), std::move(texture)};
}

Numbers texture_with_border(const fs::path& run, double border) {
  auto [packing, options] = last_packing(run, "");
  options.rev_sizes = 0;
  options.border = border;
  texture::Texture texture = texture::measure(packing, options);
  texture.per_grain = {};
  return texture::numbers(texture, false);
}

Numbers curves_of(FinalState state) {
  state.texture.per_grain = {};
  return texture::numbers(state.texture, true);
}

}  // namespace arenite::study
