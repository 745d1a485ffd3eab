#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grains/fields/regime/prediction.hpp"
#include "recipe/recipe.hpp"
#include "statistics/numbers.hpp"

// What a simulation will cost and what it will be like, before it is run. SI units.
namespace arenite::workflow {

struct Prediction {
  std::size_t grains = 0;  ///< of the recipe, where it says how many
  std::size_t sample = 0;  ///< of the sample that was made to look at; fewer where the recipe's would take long
  double time_step = 0, largest_step = 0;  ///< s; the largest that is stable
  fields::StepLimit limit = fields::StepLimit::collision;
  fields::ShortestCollision collision;
  std::string material;         ///< of that collision
  double seconds_per_step = 0;  ///< of one processor, for all grains
  std::vector<fields::StagePrediction> stages;
  std::vector<std::string> warnings;  ///< what is legal but costly or unphysical, a sentence each
  double seconds() const;             ///< of all stages
  double bytes() const;               ///< of the files of its stages, to a factor of two or so
  double bytes_of_state = 0;          ///< of a grain in a stored state
  double memory = 0;                  ///< bytes that the run takes of memory, to a tenth or two; of spheres, else 0
};

/// Looks at the recipe's sample before its loading, or at a small one of the same kind where that is large, and times
/// some hundred steps of it. Of spheres time, files and memory are predicted, not what the stages will be like. Cement,
/// grid and loads are left out. Throws InputError where the sample cannot be made.
Prediction predict(const recipe::Recipe& recipe);

Numbers numbers(const Prediction& prediction);

}  // namespace arenite::workflow
