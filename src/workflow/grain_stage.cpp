#include "workflow/grain_stage.hpp"

#include <utility>

#include "core/version.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "workflow/asked.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::workflow {

StageResult measure_stage(const GrainStage& stage, StageResult made, const std::string& kernel) {
  const auto& [recipe, place, hash, before, known] = stage;
  made.provenance = {version, made.name, hash, to_toml(part_of(recipe, place)), recipe.seed, kernel, {}, recipe.title};
  note_asked(made, recipe, place, stage.loaded_before());
  if (made.snapshots.empty()) return made;
  const texture::Options measuring = fields::texture_options(made);
  texture::Texture texture = texture::measure(made.snapshots.back().packing, measuring);
  made.texture = fields::stage_numbers(
      {made, place > 0 ? recipe.stages[place - 1] : dem::Stage{}, stage.loaded_before(), texture, &measuring});
  made.texture.update(fields::test_numbers(fields::Test{made, before}));
  if (known) *known = std::move(texture);
  return made;
}

SphereResult measure_stage(const GrainStageIn<3>& stage, SphereResult made, const std::string& kernel) {
  const auto& [recipe, place, hash, before, known] = stage;
  made.provenance = {version, made.name, hash, to_toml(part_of(recipe, place)), recipe.seed, kernel, {}, recipe.title};
  note_asked(made, recipe, place, stage.loaded_before());
  if (made.snapshots.empty()) return made;
  made.texture = texture::measure_spheres(made.snapshots.back().packing, texture::sphere_options(made.asked));
  if (place == 0) return made;
  made.texture.update(fields::loads_of(made, recipe.stages[place - 1]));
  made.texture.update(fields::energy_balance(made.history));
  made.texture.update(fields::flows_of(made, recipe.stages[place - 1], stage.loaded_before()));
  made.texture.update(fields::test_numbers(made));
  return made;
}

}  // namespace arenite::workflow
