#pragma once
#include "core/parameters.hpp"
#include "grains/dem/stage.hpp"

namespace arenite::recipe {

struct Recipe;

/// Of a stage which grains come in and leave.
void declare_exchange(ParameterVisitor& visitor, dem::Stage& stage, const Recipe& recipe);

}  // namespace arenite::recipe
