#pragma once
#include <string>

#include "recipe/document.hpp"

namespace arenite::campaign {

/// A swept key as one would say it: "stages.1.duration" is "duration of shear" where the second stage has that name,
/// "materials.sand.stiffness" "stiffness of sand", "variables.D" "D", "cement.width" "cement width".
std::string words_of_key(const recipe::Node& recipe, const std::string& key);

}  // namespace arenite::campaign
