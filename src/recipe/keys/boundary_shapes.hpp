#pragma once
#include "core/parameters.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::recipe {

struct Recipe;

void declare_boundaries(ParameterVisitor& visitor, Recipe& recipe);

}  // namespace arenite::recipe
