#include "study/final_state.hpp"

#include "core/error.hpp"
#include "io/run_folder.hpp"
#include "io/stage_file.hpp"
#include "study/recipe.hpp"
#include "study/run.hpp"

namespace arenite::study {

FinalState final_state(const std::filesystem::path& run, bool rev) {
  const auto files = io::stage_files(run);
  if (files.empty()) throw InputError(run.string(), 0, "there are no stage files of this run; remove its folder and run the study again");
  StageResult result = io::read_stage(files.back());
  if (result.frames.empty()) throw InputError(files.back().string(), 0, "this stage holds no state; remove it and run the study again");
  const Recipe recipe = parse_recipe(result.provenance.recipe, files.back().string());
  texture::Options options = texture_options(recipe, recipe.stages.size());
  if (!rev) options.rev_sizes = 0;
  FinalState state;
  state.packing = std::move(result.frames.back().packing);
  state.texture = texture::measure(state.packing, options);
  return state;
}

std::string curves_json(FinalState state) {
  state.texture.per_grain = {};
  return texture::to_json(state.texture, true);
}

}  // namespace arenite::study
