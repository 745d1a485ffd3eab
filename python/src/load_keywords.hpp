#pragma once
#include <string>

#include "keywords.hpp"
#include "recipe/recipe.hpp"

namespace arenite::python {

/// Keywords of a load, in the plane and in space.
const Keywords& load_keywords();

/// The load that they say, named as recipes name it.
recipe::Load load_of(const char* function, const std::string& loading, const py::kwargs& more);

}  // namespace arenite::python
