#pragma once
#include "core/parameters.hpp"

namespace arenite::recipe {

struct Recipe;

/// The container, and how grains are put into it; that the part of it which is filled lies inside.
void declare_container(ParameterVisitor& visitor, Recipe& recipe);
void declare_packing(ParameterVisitor& visitor, Recipe& recipe);
void require_fill_area(ParameterVisitor& visitor, const Recipe& recipe);

}  // namespace arenite::recipe
