#pragma once
#include "core/parameters.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::recipe {

struct Recipe;

void declare(ParameterVisitor& visitor, dem::Stage& stage, const Recipe& recipe);

}  // namespace arenite::recipe
