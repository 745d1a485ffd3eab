#pragma once
#include <string>
#include <vector>

#include "recipe/recipe.hpp"

namespace arenite::recipe {

/// What a recipe says that may be said, but gives another answer than its author is likely to expect: a sentence each,
/// with the key that mends it.
std::vector<std::string> doubts_of(const Recipe& recipe);

}  // namespace arenite::recipe
