#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "grains/texture/texture.hpp"
#include "model/result.hpp"
#include "recipe/recipe.hpp"

namespace arenite::workflow {

/// A stage of grains on its own, as a run and Python take it.
template <int D> struct GrainStageIn {
  const recipe::Recipe& recipe;
  std::size_t place = 0;                 ///< 0 is the packing
  std::string hash;                      ///< names its result
  const PackingIn<D>* before = nullptr;  ///< the state that it begins with; null for the packing
  std::optional<texture::Texture>* texture =
      nullptr;  ///< gets that of the last state, whose numbers the result has; nothing without states, or in space

  /// What strains refer to: the state before, where it is that of a loaded sample; null after the packing.
  const PackingIn<D>* loaded_before() const { return place > 1 ? before : nullptr; }
};
using GrainStage = GrainStageIn<2>;

/// Measures what was made of a stage by all that fields::stage_numbers knows, and says where it comes from.
StageResult measure_stage(const GrainStage& stage, StageResult made, const std::string& kernel = {});
SphereResult measure_stage(const GrainStageIn<3>& stage, SphereResult made, const std::string& kernel = {});

}  // namespace arenite::workflow
