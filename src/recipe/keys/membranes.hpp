#pragma once
#include "core/parameters.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::recipe {

struct Recipe;

/// What membranes are made of; of a stage whose keys have all been read, that its sides can be membranes.
void declare_membrane(ParameterVisitor& visitor, Recipe& recipe);
void require_membranes(ParameterVisitor& visitor, dem::Stage& stage, const Recipe& recipe);

}  // namespace arenite::recipe
