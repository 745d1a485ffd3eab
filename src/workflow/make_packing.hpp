#pragma once
#include "model/result.hpp"
#include "recipe/recipe.hpp"

namespace arenite::workflow {

/// The grains in their box before any loading: drawn, placed and relaxed, or read from a file (recipe's [packing]).
StageResult make_packing(const recipe::Recipe& recipe);
SphereResult make_sphere_packing(const recipe::Recipe& recipe);

}  // namespace arenite::workflow
