#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recipe/film_recipe.hpp"

namespace arenite::workflow {

struct RenderOptions {
  std::filesystem::path out;
  std::string format = "ptw";  ///< of the films
  bool blind =
      false;  ///< film.toml has no more than a laboratory knows: no blur, surroundings, phase or travel of the wall
  std::function<bool(double share)> progress = [](double) { return true; };  ///< false stops
};

/// Films two simulated states (or one, or a load of the cemented sample, from no load) with the recipe's [camera].
/// Writes the film, two films of black-body references, an optical picture at the smallest load, and the recipe
/// film.toml that `arenite film` takes; returns the files, none if it was stopped. `result` is a run's folder or a file
/// of it. Throws InputError for stages that are not there.
std::vector<std::filesystem::path> render_film(const recipe::FilmRecipe& recipe, const std::filesystem::path& result,
                                               const RenderOptions& options);

}  // namespace arenite::workflow
