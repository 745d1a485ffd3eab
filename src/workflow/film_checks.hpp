#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "model/lockin_maps.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::study {

/// Throws InputError if the film's levels cannot become temperatures in the way that the recipe says.
void refuse_temperatures(const FilmRecipe& recipe, const std::filesystem::path& path, const FilmInfo& film);

/// Throws InputError if nearly all pixels of a film reach the top of its range.
void refuse_saturated(const thermography::FrameStatistics& seen, const FilmInfo& film);

/// Throws InputError if nearly all pixels of a film stay as they are from its first frame on.
void refuse_constant(const thermography::FrameStatistics& seen, const FilmInfo& film);

/// What to say of maps that show no load, a film without one or told a wrong frequency; `told_by` is where that stands.
std::string no_load_sentence(const LockinMaps& maps, double frequency, std::string_view told_by);

/// Throws InputError if the maps hold nothing but noise, or a line of the camera.
void refuse_without_load(const LockinMaps& maps, double told_frequency);

/// The recipe of the simulation beside the film. Throws InputError if it has not the stages that [twin] names.
Recipe read_twin_recipe(const FilmRecipe& recipe);

}  // namespace arenite::study
