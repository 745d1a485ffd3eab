#pragma once
#include "core/parameters.hpp"
#include "recipe/recipe.hpp"

namespace arenite::study {

/// Every key of a recipe: its name, unit, range and meaning, and what must hold between keys.
void declare(ParameterVisitor& visitor, Recipe& recipe);

}  // namespace arenite::study
