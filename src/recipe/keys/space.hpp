#pragma once
#include "core/parameters.hpp"

namespace arenite::recipe {

struct Recipe;

/// Refuses, each in one sentence, what a recipe of spheres asks for that space does not have.
void require_in_space(ParameterVisitor& visitor, const Recipe& recipe);

}  // namespace arenite::recipe
