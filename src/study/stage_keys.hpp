#pragma once
#include <cstddef>
#include <string>

#include "study/recipe.hpp"

namespace arenite::study {

/// Hash of all that the packing depends on: its part of the recipe, the seed, and the bytes of the file it is read from.
std::string packing_key(const Recipe& recipe);

/// Hash of all that stage `s` (0-based) depends on: the packing, laws, integration, the stages up to it.
/// What changes no bit (title, number of threads, kernel, later stages) is not in it.
std::string stage_key(const Recipe& recipe, std::size_t s, const std::string& packing_hash);

/// Hash of all that the cemented sample depends on: the last stage, the cement and the raster.
std::string cement_key(const Recipe& recipe, const std::string& last_stage_hash);

/// Hash of all that a load depends on: the cemented sample and the load itself, but not its name's place among others.
std::string load_key(const Load& load, const std::string& cement_hash);

}  // namespace arenite::study
