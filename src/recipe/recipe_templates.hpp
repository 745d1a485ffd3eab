#pragma once
#include <string>
#include <vector>

#include "recipe/recipe.hpp"

namespace arenite::study {

/// A recipe to start from.
struct RecipeTemplate {
  const char* name;
  const char* sentence;
  Recipe (*make)();
};

/// All of packings; a new one is one row.
const std::vector<RecipeTemplate>& recipe_templates();

/// A small recipe with a [sweep], for `arenite study run`.
std::string study_template();

}  // namespace arenite::study
