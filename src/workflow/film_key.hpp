#pragma once
#include <filesystem>
#include <string>

#include "model/film.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::study {

/// Hash of a film, of all files that its recipe names, and of the recipe: what the measured film's name is made of. A film is
/// hashed by what it says about itself and by the bytes of its file, or by its frames where they lie in several files.
std::string film_key(const std::filesystem::path& film, FilmSource& source, const FilmRecipe& recipe);

}  // namespace arenite::study
