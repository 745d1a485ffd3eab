#pragma once
#include <string_view>

#include "core/parameters.hpp"

namespace arenite::recipe {

struct Recipe;

/// Every key of a recipe: its name, unit, range and meaning, and what must hold between keys. The structs that come
/// from elsewhere declare their own, and its larger parts stand in sources of theirs (keys/, loads.cpp): where the
/// keys of one must agree with others, it gets the recipe as far as it is known by then.
void declare(ParameterVisitor& visitor, Recipe& recipe);

/// When keys of grains exist.
inline constexpr std::string_view no_map = "no [map]";
/// When keys of the plane do, and of the third dimension.
inline constexpr std::string_view plane = "dimension = 2";
inline constexpr std::string_view space = "dimension = 3";

}  // namespace arenite::recipe
