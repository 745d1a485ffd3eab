#pragma once
#include <cstdint>
#include <vector>

#include "campaign/sweep.hpp"
#include "recipe/document.hpp"
#include "recipe/reader.hpp"
#include "recipe/recipe.hpp"

namespace arenite::campaign {

std::vector<Point> latin_hypercube_points(const recipe::Node& section, recipe::Reading& reading, std::uint64_t seed);

}  // namespace arenite::campaign
